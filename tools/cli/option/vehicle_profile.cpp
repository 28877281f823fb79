#include "vehicle_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "built_in_vehicles.h"
#include "cli/file/files.h"
#include "cli/run.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"
#include "numbers_option.h"
#include "traj/record/airframe_record.h"

namespace cli {
namespace {

using geom::JsonFields;
using geom::Limits;
using geom::Vec3;

constexpr double kEveryTilt = std::numbers::pi / 2;  // beyond it the box is that of less, mirrored

constexpr std::array kKeys = {"name",
                              "body",
                              "tilt_max_deg",
                              "limits",
                              "mass_kg",
                              "inertia_kg_m2",
                              "motor_time_constant_s",
                              "thrust_n",
                              "body_rate_max_rad_s",
                              "motor_arm_m",
                              "torque_per_thrust_m",
                              "drag_kg_s",
                              "battery_wh",
                              "ceiling_m",
                              "range_m",
                              "endurance_s",
                              "gains",
                              "sources"};

// A limit under a name that nobody reads would not hold.
void require_known_keys(const JsonFields& fields) {
  for (const auto& [key, value] : fields.object().items()) {
    if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
    fields.refuse(
        fmt::format("{} is no key of a vehicle's profile; expected some of: {} (remarks go into "
                    "sources)",
                    geom::shown(nlohmann::json(key)), fmt::join(kKeys, " ")));
  }
}

Limits stated_limits(const JsonFields& fields) {
  Limits limits = fields.limits();
  const std::optional<double> degrees = fields.number("tilt_max_deg");
  if (degrees && !(*degrees > 0 && *degrees <= 80)) {
    fields.refuse(fmt::format("tilt_max_deg must be above 0 and at most 80, found {}", *degrees));
  }
  Limits tilt;
  if (degrees) tilt[geom::Limit::tilt] = *degrees * std::numbers::pi / 180;
  return geom::stricter(limits, tilt);
}

// What the motors and the autopilot's rate loop can do at most. A rate about any axis between roll
// and pitch is within the smaller of both.
Limits physical_limits(const traj::Airframe& airframe) {
  Limits limits;
  if (airframe.mass && airframe.thrust_most)
    limits[geom::Limit::thrust] = *airframe.thrust_most / *airframe.mass;
  if (airframe.body_rate_max) {
    limits[geom::Limit::body_rate] = airframe.body_rate_max->head<2>().minCoeff();
    limits[geom::Limit::yaw_rate] = airframe.body_rate_max->z();
  }
  return limits;
}

VehicleProfile from_profile(const std::string& text, const std::string& source) {
  const JsonFields fields(text, source, 0);
  require_known_keys(fields);
  const Vec3 body = fields.point("body");
  if (body.minCoeff() < 0) fields.refuse("body must be half sizes >= 0 in metres");
  VehicleProfile profile;
  profile.airframe = traj::parse_airframe(fields);
  profile.body = body;
  geom::Vehicle& vehicle = profile.vehicle;
  vehicle.name = fields.text("name", source);
  vehicle.limits = geom::stricter(stated_limits(fields), physical_limits(profile.airframe));
  vehicle.half =
      geom::attitude_half_sizes(body, vehicle.limits[geom::Limit::tilt].value_or(kEveryTilt));
  return profile;
}

Vec3 half_sizes(std::string_view numbers, std::size_t count, const std::string& word) {
  const auto values = parse_numbers(numbers, count);
  if (!values || *std::min_element(values->begin(), values->end()) < 0) {
    throw UsageError(
        fmt::format("--vehicle: expected {} finite number(s) >= 0 in metres, "
                    "found \"{}\"",
                    count, word));
  }
  return count == 1 ? Vec3::Constant(values->front())
                    : Vec3((*values)[0], (*values)[1], (*values)[2]);
}

}  // namespace

VehicleProfile parse_vehicle(const std::string& word) {
  if (word.starts_with("box:")) return {{word, half_sizes(word.substr(4), 3, word)}, {}, {}};
  if (word.starts_with("sphere:")) return {{word, half_sizes(word.substr(7), 1, word)}, {}, {}};
  if (const auto text = built_in_vehicle(word); !text.empty()) {
    return from_profile(std::string(text), word);
  }
  if (word.ends_with(".json")) return from_profile(InputFile(word).read_all(), word);
  throw UsageError(
      fmt::format("--vehicle: expected tello, crazyflie, FILE.json, box:HX,HY,HZ or "
                  "sphere:R, found \"{}\"",
                  word));
}

}  // namespace cli
