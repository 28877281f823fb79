#include "limit_options.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "cli/run.h"

namespace cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::optional<double> radians(const std::optional<double>& degrees) {
  return degrees ? std::optional(*degrees * kDegree) : std::nullopt;
}

// Of a limit as the options take it.
struct Unit {
  const char* name;
  double scale;
};

Unit unit_of(std::string_view limit) {
  if (limit == "tilt") return {"degrees", 1 / kDegree};
  if (limit == "body_rate" || limit == "yaw_rate") return {"degrees/s", 1 / kDegree};
  if (limit == "jmax") return {"m/s3", 1};
  return {limit == "amax" || limit == "thrust" ? "m/s2" : "m/s", 1};
}

}  // namespace

void LimitOptions::add_to(CLI::App& app) {
  const auto positive = [&](const char* name, std::optional<double>& value, const char* text) {
    app.add_option(name, value, text)->check(CLI::PositiveNumber);
  };
  positive("--vmax", given_.vmax, "largest speed, m/s");
  positive("--amax", given_.amax, "largest acceleration, m/s2");
  positive("--jmax", given_.jmax, "largest jerk, m/s3");
  positive("--vmax-h", given_.vmax_h, "largest horizontal speed, m/s");
  positive("--vmax-v", given_.vmax_v, "largest vertical speed, m/s");
  app.add_option("--tilt", tilt_, "largest tilt of the thrust from upright, degrees")
      ->check(CLI::Range(1.0, 80.0));
  app.add_option("--thrust", given_.thrust, "largest thrust over mass, m/s2 (above 9.80665)")
      ->check(CLI::Range(9.81, 1e4));
  app.add_option("--body-rate", body_rate_,
                 "largest rate at which the thrust turns (roll and pitch), degrees/s")
      ->check(CLI::Range(0.1, 1e5));
  app.add_option("--yaw-rate", yaw_rate_, "largest yaw rate, degrees/s")
      ->check(CLI::Range(0.1, 1e4));
}

traj::Limits LimitOptions::limits() const {
  traj::Limits out = given_;
  out.tilt = radians(tilt_);
  out.body_rate = radians(body_rate_);
  out.yaw_rate = radians(yaw_rate_);
  for (const auto& [name, limit] : geom::kLimitFields) {
    if (out.*limit && !std::isfinite(*(out.*limit))) {
      throw UsageError(fmt::format("{}: expected a finite number, found {}", name, *(out.*limit)));
    }
  }
  return out;
}

std::string shown(const geom::LimitField& field, double value) {
  const Unit unit = unit_of(field.name);
  return fmt::format("{:.10g} {}", value * unit.scale, unit.name);
}

geom::Limits limits_to_check(const geom::LimitSources& sources, const std::string& vehicle) {
  const auto& asked = sources.options.tilt;
  const auto& held = sources.vehicle.tilt;
  if (sources.overridden && asked && held && *asked > *held) {
    throw UsageError(fmt::format(
        "tilt: asked for {:.10g} degrees, but the box of {} holds its body up to {:.10g} "
        "degrees only, which --override cannot change: name a --vehicle whose profile "
        "allows that tilt",
        *asked / kDegree, vehicle, *held / kDegree));
  }
  return geom::limits_that_hold(sources);
}

geom::Limits limits_to_solve(const geom::Limits& asked, const geom::Vehicle& vehicle) {
  if (const geom::LimitField* field = geom::first_above(asked, vehicle.limits)) {
    throw UsageError(fmt::format(
        "{}: asked for {}, but the vehicle {} may do at most {}: ask for no more, or name a "
        "--vehicle that may",
        field->name, shown(*field, *(asked.*field->member)), vehicle.name,
        shown(*field, *(vehicle.limits.*field->member))));
  }
  const geom::Limits limits = geom::limits_that_hold({asked, {}, vehicle.limits});
  if ((!limits.vmax && !(limits.vmax_h && limits.vmax_v)) ||
      (!limits.amax && !(limits.tilt && limits.thrust))) {
    throw UsageError(
        "no limits: give --vmax (or --vmax-h and --vmax-v) and --amax (or --tilt and --thrust)");
  }
  return limits;
}

}  // namespace cli
