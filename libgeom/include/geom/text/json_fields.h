#pragma once

// Typed access to one JSON record, with errors that name source, line, key and what stood there.
//
// Example:
//   const geom::JsonFields fields(R"({"id":"q1","from":[1,2,3],"margin":0.5})", "q.jsonl", 7);
//   assert(fields.text("id") == "q1" && fields.point("from") == geom::Vec3(1, 2, 3));
//   assert(*fields.number("margin") == 0.5 && !fields.has("to"));

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/vec3.h"
#include "geom/text/words.h"

namespace geom {

// Every accessor throws InputError(source, line, …) when the key is missing (and no fallback is
// given) or has another type. Numbers must be finite, and coordinates at most kLargestCoordinate.
class JsonFields {
 public:
  JsonFields(std::string_view json, std::string_view source, std::size_t line);
  ~JsonFields();
  JsonFields(JsonFields&&) noexcept;

  const nlohmann::json& object() const { return *object_; }
  bool has(const char* key) const;  // and it is not null
  const nlohmann::json& value(const char* key) const;
  void require_type(std::string_view type) const;  // the value of "type"

  std::string text(const char* key) const;
  std::string text(const char* key, std::string_view fallback) const;
  // One of the words, or the fallback where the key is missing.
  template <class Enum, std::size_t N>
  Enum word(const char* key, const Words<Enum, N>& words, Enum fallback) const {
    if (!has(key)) return fallback;
    const auto value = value_of(words, text(key));
    if (!value) refuse_word(key, listed(words));
    return *value;
  }
  std::optional<double> number(const char* key) const;
  Vec3 point(const char* key) const;
  std::vector<Vec3> points(const char* key) const;

  double number(const nlohmann::json& value, std::string_view what) const;
  Vec3 point(const nlohmann::json& value, std::string_view what) const;
  [[noreturn]] void refuse(Fault fault) const;

 private:
  [[noreturn]] void refuse_word(const char* key, const std::string& expected) const;

  std::unique_ptr<const nlohmann::json> object_;
  std::string source_;
  std::size_t line_;
};

}  // namespace geom
