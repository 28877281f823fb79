#include "traj/flight/vehicle_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

#include "built_in_vehicles.h"
#include "flight/airframe_record.h"
#include "flight/energy_record.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

using geom::JsonFields;
using geom::Vec3;

constexpr double kEveryTilt = std::numbers::pi / 2;  // beyond it the box is that of less, mirrored

constexpr std::array kKeys = {"name",          "also",
                              "body",          "tilt_max_deg",
                              "limits",        "mass_kg",
                              "inertia_kg_m2", "motor_time_constant_s",
                              "thrust_n",      "body_rate_max_rad_s",
                              "motor_arm_m",   "torque_per_thrust_m",
                              "drag_kg_s",     "battery_wh",
                              "ceiling_m",     "range_m",
                              "endurance_s",   "navigation_m",
                              "energy",        "gains",
                              "sources"};

// A limit under a name that nobody reads would not hold.
void require_known_keys(const JsonFields& fields) {
  for (const auto& [key, value] : fields.object().items()) {
    if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
    fields.refuse(
        {.says = fmt::format(
             "{} is no key of a vehicle's profile; expected some of: {} (remarks go into sources)",
             geom::shown(nlohmann::json(key)), fmt::join(kKeys, " "))});
  }
}

Limits stated_limits(const JsonFields& fields) {
  Limits limits = geom::read_limits(fields);
  const std::optional<double> degrees = fields.number("tilt_max_deg");
  if (degrees && !(*degrees > 0 && *degrees <= 80)) {
    fields.refuse({.key = "tilt_max_deg",
                   .expected = "above 0 and at most 80",
                   .found = fmt::to_string(*degrees)});
  }
  Limits tilt;
  if (degrees) tilt[Limit::tilt] = *degrees * std::numbers::pi / 180;
  return geom::stricter(limits, tilt);
}

// What the motors and the autopilot's rate loop can do at most. A rate about any axis between roll
// and pitch is within the smaller of both.
Limits physical_limits(const Airframe& airframe) {
  Limits limits;
  if (airframe.mass && airframe.thrust_most)
    limits[Limit::thrust] = *airframe.thrust_most / *airframe.mass;
  if (airframe.body_rate_max) {
    limits[Limit::body_rate] = airframe.body_rate_max->head<2>().minCoeff();
    limits[Limit::yaw_rate] = airframe.body_rate_max->z();
  }
  return limits;
}

std::optional<geom::Vec2> stated_navigation(const JsonFields& fields) {
  if (!fields.has("navigation_m")) return std::nullopt;
  const nlohmann::json& value = fields.value("navigation_m");
  const auto metres = [&](std::size_t i) {
    return value[i].is_number() ? value[i].get<double>() : -1;
  };
  const bool pair = value.is_array() && value.size() == 2;
  if (!pair || !(metres(0) >= 0 && metres(0) <= 100) || !(metres(1) >= 0 && metres(1) <= 100)) {
    fields.refuse(
        {.key = "navigation_m",
         .expected = "metres across and metres up or down, each from 0 to 100, as [0.5, 1]",
         .found = geom::shown(value)});
  }
  return geom::Vec2(metres(0), metres(1));
}

}  // namespace

VehicleProfile parse_vehicle_profile(std::string_view json, std::string_view source) {
  const JsonFields fields(json, source, 0);
  require_known_keys(fields);
  const Vec3 body = fields.point("body");
  if (body.minCoeff() < 0) fields.refuse({.key = "body", .expected = "half sizes >= 0 in metres"});
  VehicleProfile profile;
  profile.airframe = parse_airframe(fields);
  profile.body = body;
  profile.navigation = stated_navigation(fields);
  profile.energy = parse_energy(fields, profile.airframe);
  geom::Vehicle& vehicle = profile.vehicle;
  vehicle.name = fields.text("name", source);
  vehicle.limits = geom::stricter(stated_limits(fields), physical_limits(profile.airframe));
  vehicle.half = geom::attitude_half_sizes(body, vehicle.limits[Limit::tilt].value_or(kEveryTilt));
  return profile;
}

std::optional<VehicleProfile> vehicle_named(std::string_view name) {
  for (const BuiltInVehicle& vehicle : built_in_vehicles()) {
    if (vehicle.name != name) continue;
    VehicleProfile profile = parse_vehicle_profile(vehicle.json, name);
    profile.vehicle.name = name;
    return profile;
  }
  return std::nullopt;
}

std::vector<std::string_view> vehicle_names() {
  std::vector<std::string_view> out;
  for (const BuiltInVehicle& vehicle : built_in_vehicles()) out.push_back(vehicle.name);
  return out;
}

}  // namespace traj
