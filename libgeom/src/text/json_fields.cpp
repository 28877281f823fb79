#include "geom/text/json_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {

using Json = nlohmann::json;

namespace {

bool is_finite_number(const Json& value) {
  return value.is_number() && std::isfinite(value.get<double>());
}

// Most values are right, so `what` says what they are only where one is refused.
template <class What>
Vec3 read_point(const JsonFields& fields, const Json& value, const What& what) {
  if (!value.is_array() || value.size() != 3) {
    fields.refuse({.key = std::string(what()), .expected = "[x,y,z]", .found = shown(value)});
  }
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const Json& coordinate = value[static_cast<std::size_t>(i)];
    v[i] = is_finite_number(coordinate)
               ? coordinate.get<double>()
               : fields.number(coordinate, fmt::format("{}[{}]", what(), i));
    if (std::abs(v[i]) > kLargestCoordinate) {
      fields.refuse({.key = fmt::format("{}[{}]", what(), i),
                     .expected = "within 1e8 m",
                     .found = shown(coordinate)});
    }
  }
  return v;
}

}  // namespace

JsonFields::JsonFields(std::string_view json, std::string_view source, std::size_t line)
    : object_(std::make_unique<Json>(parse_json(json, source, line))),
      source_(source),
      line_(line) {
  if (!object_->is_object()) refuse({.expected = "a JSON object", .found = shown(*object_)});
}

JsonFields::~JsonFields() = default;
JsonFields::JsonFields(JsonFields&&) noexcept = default;

bool JsonFields::has(const char* key) const {
  const auto at = object_->find(key);
  return at != object_->end() && !at->is_null();
}

const Json& JsonFields::value(const char* key) const {
  if (!has(key)) refuse({.expected = fmt::format("the key \"{}\"", key), .found = "none"});
  return (*object_)[key];
}

void JsonFields::refuse(Fault fault) const { throw InputError(source_, line_, std::move(fault)); }

void JsonFields::require_type(std::string_view type) const {
  if (!has("type")) {
    refuse(
        {.expected = fmt::format("a record of type \"{}\"", type), .found = "one without a type"});
  }
  const std::string found = shown(value("type"));
  if (found != fmt::format("\"{}\"", type)) {
    refuse({.expected = fmt::format("a record of type \"{}\"", type),
            .found = fmt::format("type {}", found)});
  }
}

std::string JsonFields::text(const char* key) const {
  if (!value(key).is_string()) {
    refuse({.key = std::string(key), .expected = "a string", .found = shown(value(key))});
  }
  return value(key).get<std::string>();
}

std::string JsonFields::text(const char* key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}

void JsonFields::refuse_word(const char* key, const std::string& expected) const {
  refuse({.key = std::string(key),
          .expected = fmt::format("one of {}", expected),
          .found = shown(value(key))});
}

double JsonFields::number(const Json& value, std::string_view what) const {
  if (!is_finite_number(value)) {
    refuse({.key = std::string(what), .expected = "a finite number", .found = shown(value)});
  }
  return value.get<double>();
}

std::optional<double> JsonFields::number(const char* key) const {
  if (!has(key)) return std::nullopt;
  return number(value(key), key);
}

Vec3 JsonFields::point(const Json& value, std::string_view what) const {
  return read_point(*this, value, [&] { return what; });
}

Vec3 JsonFields::point(const char* key) const { return point(value(key), key); }

std::vector<Vec3> JsonFields::points(const char* key) const {
  if (!has(key)) refuse({.expected = fmt::format("the key \"{}\"", key), .found = "none"});
  const Json& list = value(key);
  if (!list.is_array())
    refuse({.key = std::string(key), .expected = "a list", .found = shown(list)});
  std::vector<Vec3> points;
  points.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    points.push_back(read_point(*this, list[i], [&] { return fmt::format("{}[{}]", key, i); }));
  }
  return points;
}

}  // namespace geom
