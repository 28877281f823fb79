#include "geom/text/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

}  // namespace

JsonFields::JsonFields(std::string_view json, std::string_view source, std::size_t line)
    : object_(std::make_unique<Json>(parse_json(json, source, line))),
      source_(source),
      line_(line) {
  if (!object_->is_object()) refuse("expected a JSON object, found " + shown(*object_));
}

JsonFields::~JsonFields() = default;
JsonFields::JsonFields(JsonFields&&) noexcept = default;

bool JsonFields::has(const char* key) const {
  const auto at = object_->find(key);
  return at != object_->end() && !at->is_null();
}

const Json& JsonFields::value(const char* key) const {
  if (!has(key)) refuse(fmt::format("expected the key \"{}\", found none", key));
  return (*object_)[key];
}

void JsonFields::refuse(std::string_view message) const {
  throw InputError(source_, line_, message);
}

void JsonFields::require_type(std::string_view type) const {
  const std::string found = has("type") ? shown(value("type")) : "none";
  if (found != fmt::format("\"{}\"", type)) {
    refuse(fmt::format("expected a record of type \"{}\", found type {}", type, found));
  }
}

std::string JsonFields::text(const char* key) const {
  if (!value(key).is_string()) {
    refuse(fmt::format("{} must be a string, found {}", key, shown(value(key))));
  }
  return value(key).get<std::string>();
}

std::string JsonFields::text(const char* key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}

void JsonFields::refuse_word(const char* key, const std::string& expected) const {
  refuse(fmt::format("{} must be one of {}, found {}", key, expected, shown(value(key))));
}

double JsonFields::number(const Json& value, std::string_view what) const {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    refuse(fmt::format("{} must be a finite number, found {}", what, shown(value)));
  }
  return value.get<double>();
}

std::optional<double> JsonFields::number(const char* key) const {
  if (!has(key)) return std::nullopt;
  return number(value(key), key);
}

Vec3 JsonFields::point(const Json& value, std::string_view what) const {
  if (!value.is_array() || value.size() != 3) {
    refuse(fmt::format("{} must be [x,y,z], found {}", what, shown(value)));
  }
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    v[i] = number(value[i], fmt::format("{}[{}]", what, i));
    if (std::abs(v[i]) > kLargestCoordinate) {
      refuse(fmt::format("{}[{}] must be within 1e8 m, found {}", what, i, shown(value[i])));
    }
  }
  return v;
}

Vec3 JsonFields::point(const char* key) const { return point(value(key), key); }

std::vector<Vec3> JsonFields::points(const char* key) const {
  if (!has(key)) refuse(fmt::format("expected the key \"{}\", found none", key));
  const Json& list = value(key);
  if (!list.is_array()) refuse(fmt::format("{} must be a list, found {}", key, shown(list)));
  std::vector<Vec3> points;
  points.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    points.push_back(point(list[i], fmt::format("{}[{}]", key, i)));
  }
  return points;
}

Limits JsonFields::limits(const Json& value, std::string_view what) const {
  if (!value.is_object()) refuse(fmt::format("{} must be an object, found {}", what, shown(value)));
  Limits out;
  for (const auto& [key, entry] : value.items()) {
    const auto kind = std::find_if(kLimitKinds.begin(), kLimitKinds.end(),
                                   [&](const LimitKind& k) { return key == k.name; });
    if (kind == kLimitKinds.end()) {
      std::string names;
      for (const LimitKind& k : kLimitKinds) names += fmt::format(" {}", k.name);
      refuse(fmt::format("{} has {}, which is no limit; expected some of:{}", what,
                         shown(Json(key)), names));
    }
    const std::string where = fmt::format("{}.{}", what, key);
    const double limit = number(entry, where);
    if (!(limit > 0)) refuse(fmt::format("{} must be > 0, found {}", where, shown(entry)));
    out[kind->limit] = limit;
  }
  if (const auto& tilt = out[Limit::tilt]; tilt && *tilt >= std::numbers::pi / 2) {
    refuse(
        fmt::format("{}.tilt must be below a right angle, 1.5707963 rad, found {}", what, *tilt));
  }
  if (const auto& thrust = out[Limit::thrust]; thrust && *thrust <= kGravity) {
    refuse(fmt::format("{}.thrust must be > {} m/s2, found {}", what, kGravity, *thrust));
  }
  return out;
}

Limits JsonFields::limits() const {
  return has("limits") ? limits(value("limits"), "limits") : Limits{};
}

Provenance JsonFields::provenance() const {
  Provenance p;
  if (has("map")) p.map = text("map");
  if (has("frame")) {
    p.frame = axes_from_name(text("frame"));
    if (!p.frame) refuse("frame must be \"enu\" or \"neu\", found " + shown(value("frame")));
  }
  if (has("vehicle")) {
    const Json& v = value("vehicle");
    if (!v.is_object() || !v.contains("half")) {
      refuse("vehicle must be an object with \"half\", found " + shown(v));
    }
    Vehicle vehicle;
    if (v.contains("name") && v["name"].is_string()) vehicle.name = v["name"].get<std::string>();
    vehicle.half = point(v["half"], "vehicle.half");
    if (vehicle.half.minCoeff() < 0) {
      refuse("vehicle.half must be >= 0, found " + shown(v["half"]));
    }
    if (v.contains("limits")) vehicle.limits = limits(v["limits"], "vehicle.limits");
    p.vehicle = vehicle;
  }
  if ((p.margin = number("margin")) && *p.margin < 0) {
    refuse("margin must be >= 0, found " + shown(value("margin")));
  }
  if (p.margin && *p.margin > kLargestCoordinate) {
    refuse("margin must be within 1e8 m, found " + shown(value("margin")));
  }
  return p;
}

}  // namespace geom
