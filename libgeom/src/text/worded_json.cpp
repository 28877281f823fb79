#include "worded_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/parse_json.h"
#include "text/json_outline.h"

namespace geom {
namespace {

constexpr int kNumberOverflow = 406;  // of the parser's exceptions

// A pointer into the text that tells how far the parser has read.
class Reading {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Reading(const char* at, const char** seen) : at_(at), seen_(seen) {}
  reference operator*() const { return *at_; }
  Reading& operator++() {
    *seen_ = ++at_;
    return *this;
  }
  bool operator==(const Reading& other) const { return at_ == other.at_; }
  bool operator!=(const Reading& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** seen_;
};

// Builds the value from what the parser finds, and refuses what must not be.
template <class Json>
class Builder {
 public:
  // Of lists and objects nested deeper than `kept` the builder empties each that it has read.
  Builder(std::string_view text, std::string_view source, std::size_t line,
          std::size_t kept = kDeepestJson)
      : text_(text), source_(source), line_(line), kept_(kept) {}

  Json build() {
    seen_ = understood_ = text_.data();
    const Reading begin(text_.data(), &seen_);
    const Reading end(text_.data() + text_.size(), &seen_);
    Json::sax_parse(begin, end, this);
    // The parser takes a byte of zero behind the value for the end of the text.
    if (const std::size_t zero = text_.find('\0'); zero != text_.npos) {
      refuse_at(text_.data() + zero, {.says = "this is not JSON",
                                      .expected = "nothing after the value",
                                      .found = found(text_.data() + zero)});
    }
    return std::move(root_);
  }

  // What the parser calls; each returns whether to go on.
  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(typename Json::binary_t&) { return false; }  // not in JSON text
  bool start_object(std::size_t) { return open(Json::value_t::object); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json::value_t::array); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    keyed_ = add_key(name);
    if (!keyed_) {
      refuse_at(due().at,
                {.expected = "each key once", .found = fmt::format("\"{}\" again", excerpt(name))});
    }
    fresh_ = false;
    understood_ = seen_;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& why) {
    const Due due = this->due();
    const bool string = due.takes_string && due.at != end() && *due.at == '"';
    const std::string_view expected =
        why.id == kNumberOverflow ? "a number that a double holds (up to 1.8e308)"
        : string                  ? "a string in UTF-8 that ends, with \\ before control characters"
                                  : due.what;
    refuse_at(due.at, {.says = why.id == kNumberOverflow ? "" : "this is not JSON",
                       .expected = std::string(expected),
                       .found = found(due.at)});
    return false;
  }

 private:
  struct Level {
    Json* value;
    std::unordered_set<std::string> keys;  // of an object whose keys keep their order
  };

  // Says the line and the column of `at`.
  [[noreturn]] void refuse_at(const char* at, Fault fault) const {
    const auto before = text_.substr(0, static_cast<std::size_t>(at - text_.data()));
    const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    throw InputError(source_, line_ ? line_ : lines + 1,
                     within(fmt::format("column {}", before.size() - begin + 1), std::move(fault)));
  }

  // Puts a value where one is due.
  template <class Value>
  Json* place(Value&& value) {
    begun_ = true;
    if (levels_.empty()) return &(root_ = std::forward<Value>(value));
    if (levels_.back().value->is_object()) {
      return &(*std::exchange(keyed_, nullptr) = std::forward<Value>(value));
    }
    auto& list = levels_.back().value->template get_ref<typename Json::array_t&>();
    return &list.emplace_back(std::forward<Value>(value));
  }

  template <class Value>
  bool add(Value&& value) {
    constexpr bool kNumber = std::is_arithmetic_v<std::remove_cvref_t<Value>> &&
                             !std::is_same_v<std::remove_cvref_t<Value>, bool>;
    place(std::forward<Value>(value));
    fresh_ = false;
    understood_ = seen_;
    // The parser reads one character past a number.
    const bool past =
        kNumber && std::string_view("0123456789").find(seen_[-1]) == std::string_view::npos;
    if (past) --understood_;
    return true;
  }

  bool open(typename Json::value_t kind) {
    if (levels_.size() == kDeepestJson) {
      refuse_at(seen_ - 1,
                {.expected = fmt::format("lists and objects nested at most {} deep", kDeepestJson),
                 .found = "more"});
    }
    levels_.push_back({place(Json(kind)), {}});
    fresh_ = true;
    understood_ = seen_;
    return true;
  }

  bool close() {
    if (levels_.size() > kept_) levels_.back().value->clear();
    levels_.pop_back();
    fresh_ = false;
    understood_ = seen_;
    return true;
  }

  // Where the value of the key goes; nothing, and `name` as it was, where the object has that key
  // already.
  Json* add_key(std::string& name) {
    auto& object = levels_.back().value->template get_ref<typename Json::object_t&>();
    if constexpr (std::is_same_v<Json, nlohmann::json>) {
      const auto [at, fresh] = object.try_emplace(std::move(name));
      return fresh ? &at->second : nullptr;
    } else {  // a vector, in which looking for each key would be quadratic
      if (!levels_.back().keys.insert(name).second) return nullptr;
      auto& list = static_cast<typename Json::object_t::Container&>(object);
      return &list.emplace_back(std::move(name), Json()).second;
    }
  }

  // What had to come behind what was understood, and where.
  struct Due {
    const char* at;
    std::string_view what;
    bool takes_string = false;  // a string would do
  };

  Due due() const {
    const char* const at = after_blanks(understood_);
    if (levels_.empty()) {
      return begun_ ? Due{at, "nothing after the value"} : Due{at, "a value", true};
    }
    const bool object = levels_.back().value->is_object();
    if (fresh_) return {at, object ? "a key in quotes or }" : "a value or ]", true};
    const char mark = keyed_ ? ':' : ',';
    if (at != end() && *at == mark && at < seen_) {
      return {after_blanks(at + 1), object && !keyed_ ? "a key in quotes" : "a value", true};
    }
    return {at, keyed_ ? ": after the key" : object ? ", or }" : ", or ]"};
  }

  const char* end() const { return text_.data() + text_.size(); }
  const char* after_blanks(const char* at) const {
    while (at != end() && std::string_view(" \t\r\n").find(*at) != std::string_view::npos) ++at;
    return at;
  }

  // The word that stands at `at`.
  std::string found(const char* at) const {
    if (at == end()) return "the end";
    const std::string_view rest(at, static_cast<std::size_t>(end() - at));
    const std::size_t stop = rest.starts_with('"') ? rest.find_first_of("\"\n", 1) + 1
                                                   : rest.find_first_of(" \t\r\n,:]}", 1);
    return excerpt(rest.substr(0, stop ? stop : rest.npos), 40);
  }

  std::string_view text_;
  std::string source_;
  std::size_t line_;
  std::size_t kept_;
  const char* seen_ = nullptr;        // behind the last character that was read
  const char* understood_ = nullptr;  // behind what the values so far were made of
  Json root_;
  bool begun_ = false;         // there is a root
  bool fresh_ = false;         // the innermost list or object was opened last
  std::vector<Level> levels_;  // lists and objects that are not closed
  Json* keyed_ = nullptr;      // where the value of the last key goes
};

template <class Json>
Json parse(std::string_view text, std::string_view source, std::size_t line) {
  return Builder<Json>(text, source, line).build();
}

}  // namespace

nlohmann::json worded_json(std::string_view text, std::string_view source, std::size_t line) {
  return parse<nlohmann::json>(text, source, line);
}

nlohmann::ordered_json worded_ordered_json(std::string_view text, std::string_view source) {
  return parse<nlohmann::ordered_json>(text, source, 0);
}

nlohmann::json json_outline(std::string_view text, std::string_view source, std::size_t depth,
                            std::size_t line) {
  return Builder<nlohmann::json>(text, source, line, depth).build();
}

}  // namespace geom
