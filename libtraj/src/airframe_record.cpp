#include "traj/io/airframe_record.h"

#include <fmt/format.h>

#include "traj/limits.h"

namespace traj {
namespace {

using geom::JsonFields;
using geom::Vec3;

std::optional<double> positive(const JsonFields& fields, const char* key) {
  const std::optional<double> value = fields.number(key);
  if (value && *value <= 0) fields.refuse(fmt::format("{} must be > 0, found {}", key, *value));
  return value;
}

std::optional<Vec3> positive_axes(const JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  const Vec3 value = fields.point(key);
  if (value.minCoeff() <= 0) {
    fields.refuse(
        fmt::format("{} must be > 0 about each axis, found {}", key, fields.object()[key].dump()));
  }
  return value;
}

// No body has more inertia about one axis than about the other two together.
std::optional<Vec3> inertia(const JsonFields& fields) {
  const auto value = positive_axes(fields, "inertia_kg_m2");
  if (value && 2 * value->maxCoeff() > value->sum() * (1 + 1e-9)) {
    fields.refuse(
        fmt::format("inertia_kg_m2 must be at most the sum of the other two about each "
                    "axis, found {}",
                    fields.object()["inertia_kg_m2"].dump()));
  }
  return value;
}

void parse_thrust(const JsonFields& fields, Airframe& airframe) {
  if (!fields.has("thrust_n")) return;
  const auto& range = fields.object()["thrust_n"];
  if (!range.is_array() || range.size() != 2) {
    fields.refuse(fmt::format("thrust_n must be [least,most], found {}", range.dump()));
  }
  airframe.thrust_least = fields.number(range[0], "thrust_n[0]");
  airframe.thrust_most = fields.number(range[1], "thrust_n[1]");
  if (*airframe.thrust_least < 0 || *airframe.thrust_least >= *airframe.thrust_most) {
    fields.refuse(fmt::format("thrust_n must be 0 <= least < most, found {}", range.dump()));
  }
  if (airframe.mass && *airframe.thrust_most <= *airframe.mass * kGravity) {
    fields.refuse(fmt::format("thrust_n must reach more than the weight, {:.4g} N, found {}",
                              *airframe.mass * kGravity, range.dump()));
  }
}

}  // namespace

Airframe parse_airframe(const JsonFields& fields) {
  Airframe airframe;
  airframe.mass = positive(fields, "mass_kg");
  airframe.inertia = inertia(fields);
  airframe.motor_time_constant = positive(fields, "motor_time_constant_s");
  parse_thrust(fields, airframe);
  airframe.body_rate_max = positive_axes(fields, "body_rate_max_rad_s");
  airframe.ceiling = positive(fields, "ceiling_m");
  airframe.range = positive(fields, "range_m");
  airframe.endurance = positive(fields, "endurance_s");
  return airframe;
}

}  // namespace traj
