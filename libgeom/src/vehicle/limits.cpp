#include "geom/vehicle/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

std::optional<double> smaller(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Limits stricter(const Limits& a, const Limits& b) {
  Limits out;
  for (const LimitKind& kind : kLimitKinds) out[kind.limit] = smaller(a[kind.limit], b[kind.limit]);
  return out;
}

std::optional<Limit> first_above(const Limits& a, const Limits& b) {
  for (const LimitKind& kind : kLimitKinds) {
    const auto& ours = a[kind.limit];
    const auto& theirs = b[kind.limit];
    if (ours && theirs && *ours > *theirs) return kind.limit;
  }
  return std::nullopt;
}

Limits limits_that_hold(const LimitSources& sources) {
  Limits out = stricter(sources.record, sources.vehicle);
  for (const LimitKind& kind : kLimitKinds) {
    const auto& asked = sources.options[kind.limit];
    std::optional<double>& held = out[kind.limit];
    if (asked) held = sources.overridden ? asked : smaller(asked, held);
  }
  out[Limit::tilt] = smaller(out[Limit::tilt], sources.vehicle[Limit::tilt]);
  return out;
}

void add(JsonLine& line, const Limits& limits) {
  JsonLine present;
  for (const LimitKind& kind : kLimitKinds) present.add(kind.name, limits[kind.limit]);
  if (!present.empty()) line.add("limits", present);
}

Limits read_limits(const JsonFields& fields, const nlohmann::json& value, std::string_view what) {
  if (!value.is_object())
    fields.refuse({.key = std::string(what), .expected = "an object", .found = shown(value)});
  Limits out;
  for (const auto& [key, entry] : value.items()) {
    const auto kind = std::find_if(kLimitKinds.begin(), kLimitKinds.end(),
                                   [&name = key](const LimitKind& k) { return name == k.name; });
    if (kind == kLimitKinds.end()) {
      std::string names;
      for (const LimitKind& k : kLimitKinds) names += fmt::format(" {}", k.name);
      fields.refuse({.says = fmt::format("{} has {}, which is no limit; expected some of:{}", what,
                                         shown(nlohmann::json(key)), names)});
    }
    const std::string where = fmt::format("{}.{}", what, key);
    const double limit = fields.number(entry, where);
    if (!(limit > 0)) fields.refuse({.key = where, .expected = "> 0", .found = shown(entry)});
    out[kind->limit] = limit;
  }
  if (const auto& tilt = out[Limit::tilt]; tilt && *tilt >= std::numbers::pi / 2) {
    fields.refuse({.key = fmt::format("{}.tilt", what),
                   .expected = "below a right angle, 1.5707963 rad",
                   .found = fmt::to_string(*tilt)});
  }
  if (const auto& thrust = out[Limit::thrust]; thrust && *thrust <= kGravity) {
    fields.refuse({.key = fmt::format("{}.thrust", what),
                   .expected = fmt::format("> {} m/s2", kGravity),
                   .found = fmt::to_string(*thrust)});
  }
  return out;
}

Limits read_limits(const JsonFields& fields) {
  return fields.has("limits") ? read_limits(fields, fields.value("limits"), "limits") : Limits{};
}

}  // namespace geom
