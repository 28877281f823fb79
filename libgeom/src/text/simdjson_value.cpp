#include "simdjson_value.h"

#include <simdjson.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;
namespace dom = simdjson::dom;

// A zero with a sign is a signed number here, and simdjson's integers have lost that sign. What
// looks so within a string counts, too.
bool has_signed_zero(std::string_view text) {
  constexpr std::string_view kBefore = " \t\r\n[,:";
  for (std::size_t at = text.find("-0"); at != text.npos; at = text.find("-0", at + 2)) {
    const bool begins = at == 0 || kBefore.find(text[at - 1]) != kBefore.npos;
    const char next = at + 2 < text.size() ? text[at + 2] : ' ';
    if (begins && next != '.' && next != 'e' && next != 'E') return true;
  }
  return false;
}

// Copies simdjson's tape; false where the value may not be what parse_json makes.
class Copy {
 public:
  explicit Copy(std::string_view text) : text_(text) {}

  bool value(const dom::element& from, Json& to, std::size_t depth) {
    switch (from.type()) {
      case dom::element_type::ARRAY:
        return depth < kDeepestJson && array(from.get_array().value_unsafe(), to, depth + 1);
      case dom::element_type::OBJECT:
        return depth < kDeepestJson && object(from.get_object().value_unsafe(), to, depth + 1);
      case dom::element_type::INT64:
        return integer(from.get_int64().value_unsafe(), to);
      case dom::element_type::UINT64:
        to = from.get_uint64().value_unsafe();
        return true;
      case dom::element_type::DOUBLE:
        to = from.get_double().value_unsafe();
        return true;
      case dom::element_type::STRING:
        to = std::string(from.get_string().value_unsafe());
        return true;
      case dom::element_type::BOOL:
        to = from.get_bool().value_unsafe();
        return true;
      case dom::element_type::NULL_VALUE:
        return true;
    }
    return false;
  }

 private:
  bool array(const dom::array& from, Json& to, std::size_t depth) {
    Json::array_t list;
    list.reserve(from.size());
    for (const dom::element one : from) {
      if (!value(one, list.emplace_back(), depth)) return false;
    }
    to = std::move(list);
    return true;
  }

  bool object(const dom::object& from, Json& to, std::size_t depth) {
    Json::object_t members;
    for (const auto& [key, one] : from) {
      const auto [at, fresh] = members.try_emplace(std::string(key));
      if (!fresh || !value(one, at->second, depth)) return false;
    }
    to = std::move(members);
    return true;
  }

  bool integer(std::int64_t from, Json& to) {
    if (from < 0) {
      to = from;
      return true;
    }
    to = static_cast<std::uint64_t>(from);
    if (from == 0 && !looked_) {
      looked_ = true;
      return !has_signed_zero(text_);
    }
    return true;
  }

  std::string_view text_;
  bool looked_ = false;  // for a signed zero, of which there is none
};

}  // namespace

std::optional<Json> simdjson_value(std::string_view text) {
  // To simdjson a byte of zero may end a number.
  if (text.size() > kLongestForSimdjson || text.find('\0') != text.npos) return std::nullopt;
  dom::parser parser;
  dom::element root;
  if (parser.parse(text.data(), text.size()).get(root) != simdjson::SUCCESS) return std::nullopt;
  Json out;
  if (!Copy(text).value(root, out, 0)) return std::nullopt;
  return out;
}

}  // namespace geom
