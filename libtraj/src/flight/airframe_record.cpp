#include "flight/airframe_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "traj/flight/gains_record.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

using geom::JsonFields;
using geom::Vec3;

constexpr double kRadian = 0.017453292519943295;  // of a degree

std::optional<double> positive(const JsonFields& fields, const char* key) {
  const std::optional<double> value = fields.number(key);
  if (value && *value <= 0)
    fields.refuse({.key = std::string(key), .expected = "> 0", .found = fmt::to_string(*value)});
  return value;
}

std::optional<Vec3> positive_axes(const JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  const Vec3 value = fields.point(key);
  if (value.minCoeff() <= 0) {
    fields.refuse({.key = std::string(key),
                   .expected = "> 0 about each axis",
                   .found = fields.value(key).dump()});
  }
  return value;
}

// No body has more inertia about one axis than about the other two together.
std::optional<Vec3> inertia(const JsonFields& fields) {
  const auto value = positive_axes(fields, "inertia_kg_m2");
  if (value && 2 * value->maxCoeff() > value->sum() * (1 + 1e-9)) {
    fields.refuse({.key = "inertia_kg_m2",
                   .expected = "at most the sum of the other two about each axis",
                   .found = fields.value("inertia_kg_m2").dump()});
  }
  return value;
}

void parse_thrust(const JsonFields& fields, Airframe& airframe) {
  if (!fields.has("thrust_n")) return;
  const auto& range = fields.value("thrust_n");
  if (!range.is_array() || range.size() != 2) {
    fields.refuse({.key = "thrust_n", .expected = "[least,most]", .found = range.dump()});
  }
  airframe.thrust_least = fields.number(range[0], "thrust_n[0]");
  airframe.thrust_most = fields.number(range[1], "thrust_n[1]");
  if (*airframe.thrust_least < 0 || *airframe.thrust_least >= *airframe.thrust_most) {
    fields.refuse({.key = "thrust_n", .expected = "0 <= least < most", .found = range.dump()});
  }
  if (airframe.mass && *airframe.thrust_most <= *airframe.mass * kGravity) {
    fields.refuse({.says = fmt::format("thrust_n must reach more than the weight, {:.4g} N",
                                       *airframe.mass * kGravity),
                   .found = range.dump()});
  }
}

std::optional<Eigen::Vector2d> arm(const JsonFields& fields) {
  if (!fields.has("motor_arm_m")) return std::nullopt;
  const auto& value = fields.value("motor_arm_m");
  if (!value.is_array() || value.size() != 2) {
    fields.refuse({.key = "motor_arm_m", .expected = "[x,y]", .found = value.dump()});
  }
  const Eigen::Vector2d out(fields.number(value[0], "motor_arm_m[0]"),
                            fields.number(value[1], "motor_arm_m[1]"));
  if (out.minCoeff() <= 0) {
    fields.refuse({.key = "motor_arm_m", .expected = "> 0 on both axes", .found = value.dump()});
  }
  return out;
}

std::optional<Vec3> drag(const JsonFields& fields) {
  if (!fields.has("drag_kg_s")) return std::nullopt;
  const Vec3 value = fields.point("drag_kg_s");
  if (value.minCoeff() < 0) {
    fields.refuse({.key = "drag_kg_s",
                   .expected = ">= 0 on each axis",
                   .found = fields.value("drag_kg_s").dump()});
  }
  return value;
}

constexpr double kTiltMax = 35;  // degrees, where a profile gives none

std::optional<Gains> gains(const JsonFields& fields, const Airframe& airframe) {
  const std::optional<Quadrotor> quadrotor = quadrotor_of(airframe);
  if (quadrotor) {
    const double tilt = fields.number("tilt_max_deg").value_or(kTiltMax);
    if (tilt < 0 || tilt > 80) fields.refuse({.key = "tilt_max_deg", .expected = "within 0 to 80"});
    return parse_gains(fields, nominal_gains(*quadrotor, (tilt > 0 ? tilt : kTiltMax) * kRadian));
  }
  if (fields.has("gains")) {
    fields.refuse({.says = "gains need mass_kg, inertia_kg_m2, motor_time_constant_s, thrust_n, "
                           "motor_arm_m and torque_per_thrust_m beside them"});
  }
  return std::nullopt;
}

}  // namespace

std::optional<Quadrotor> quadrotor_of(const Airframe& a) {
  if (!a.mass || !a.inertia || !a.motor_time_constant || !a.thrust_most || !a.arm ||
      !a.torque_per_thrust) {
    return std::nullopt;
  }
  Quadrotor out;
  out.mass = *a.mass;
  out.inertia = *a.inertia;
  out.arm = *a.arm;
  out.torque_per_thrust = *a.torque_per_thrust;
  out.motor_time_constant = *a.motor_time_constant;
  out.motor_least = *a.thrust_least / 4;
  out.motor_most = *a.thrust_most / 4;
  out.drag = a.drag.value_or(Vec3::Zero());
  // MC_ROLLRATE_MAX, MC_PITCHRATE_MAX 220 deg/s, MC_YAWRATE_MAX 200 deg/s.
  out.body_rate_max = a.body_rate_max.value_or(Vec3(220, 220, 200) * kRadian);
  return out;
}

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
  airframe.arm = arm(fields);
  airframe.torque_per_thrust = positive(fields, "torque_per_thrust_m");
  airframe.drag = drag(fields);
  airframe.battery = positive(fields, "battery_wh");
  airframe.gains = gains(fields, airframe);
  return airframe;
}

}  // namespace traj
