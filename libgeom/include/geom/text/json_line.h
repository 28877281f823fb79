#pragma once

// JSON objects as text on one line: what all our records are written with.
//
// Example:
//   geom::JsonLine line;
//   line.add("type", "path").add("id", "q1").add("points", path.front());
//   line.add("vehicle", geom::JsonLine().add("name", "quad").add("half", vehicle.half));
//   std::cout << line.line();  // {"type":"path","id":"q1","points":[1,1,1],"vehicle":{…}}

#include <concepts>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

namespace geom {

// An object whose members are added one by one, in the order in which they will stand. A key that
// comes twice is not noticed.
//
// Values are doubles (as append_number of number.h writes them), whole numbers, bool, nullptr,
// text, other lines, and lists: ranges of values, such as a Vec3, and tuples of values of several
// types. An optional without a value is null in a list; as a member it is left out. What is not
// UTF-8 in a text becomes U+FFFD: a name that nobody can read must not stop a report about it.
class JsonLine {
 public:
  template <class Value>
  JsonLine& add(std::string_view key, const Value& value) {
    append_key(key);
    append(value);
    return *this;
  }
  template <class Value>
  JsonLine& add(std::string_view key, const std::optional<Value>& value) {
    return value ? add(key, *value) : *this;
  }

  // A list of what `value_of` gives for each item; it may be a pointer to a member.
  template <class Range, class ValueOf>
  JsonLine& add(std::string_view key, const Range& items, const ValueOf& value_of) {
    append_key(key);
    append_list(items, value_of);
    return *this;
  }

  // A value that is JSON already, on one line.
  JsonLine& add_json(std::string_view key, std::string_view json);

  bool empty() const { return text_.size() == 1; }  // without members

  std::string object() const { return text_ + '}'; }
  std::string line() const { return text_ + "}\n"; }

 private:
  template <class Value>
  void append(const Value& value) {
    if constexpr (std::same_as<Value, std::nullptr_t>) {
      text_ += "null";
    } else if constexpr (std::same_as<Value, bool>) {
      text_ += value ? "true" : "false";
    } else if constexpr (std::same_as<Value, double>) {
      append_double(value);
    } else if constexpr (std::integral<Value> && !std::same_as<Value, char>) {
      text_ += std::to_string(value);
    } else if constexpr (std::convertible_to<const Value&, std::string_view>) {
      append_text(value);
    } else if constexpr (std::same_as<Value, JsonLine>) {
      text_ += value.text_;
      text_ += '}';
    } else if constexpr (requires { value.begin() != value.end(); }) {
      append_list(value, std::identity());
    } else {
      text_ += '[';
      std::apply([this](const auto&... items) { (append_item(items), ...); }, value);
      text_ += ']';
    }
  }

  template <class Value>
  void append(const std::optional<Value>& value) {
    value ? append(*value) : append(nullptr);
  }

  template <class Range, class ValueOf>
  void append_list(const Range& items, const ValueOf& value_of) {
    text_ += '[';
    for (const auto& item : items) append_item(std::invoke(value_of, item));
    text_ += ']';
  }

  template <class Value>
  void append_item(const Value& value) {
    separate();
    append(value);
  }

  void separate();  // a comma, but at the beginning of a list or object
  void append_key(std::string_view key);
  void append_double(double value);
  void append_text(std::string_view text);

  std::string text_ = "{";
};

}  // namespace geom
