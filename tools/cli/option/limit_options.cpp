#include "limit_options.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/answer/exit.h"
#include "geom/vehicle/shown_limit.h"

namespace cli {

using geom::kRadiansPerDegree;
using geom::Limit;

void LimitOptions::add_to(CLI::App& app) {
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    CLI::Option* option = app.add_option(kind.option, given_[kind.limit], kind.meaning);
    if (kind.most > 0) {
      option->check(CLI::Range(kind.least, kind.most));
    } else {
      option->check(CLI::PositiveNumber);
    }
  }
}

traj::Limits LimitOptions::limits() const {
  traj::Limits out;
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    const std::optional<double>& given = given_[kind.limit];
    if (!given) continue;
    if (!std::isfinite(*given)) {
      throw UsageError(fmt::format("{}: expected a finite number, found {}", kind.name, *given));
    }
    out[kind.limit] = *given * kind.in_unit;
  }
  return out;
}

namespace {

void require_speed_and_acceleration(const geom::Limits& limits, const std::string& vehicle) {
  const bool speed =
      limits[Limit::speed] || (limits[Limit::horizontal_speed] && limits[Limit::vertical_speed]);
  const bool acceleration =
      limits[Limit::acceleration] || (limits[Limit::tilt] && limits[Limit::thrust]);
  constexpr const char* kSpeed = "--vmax (or --vmax-h and --vmax-v)";
  constexpr const char* kAcceleration = "--amax (or --tilt and --thrust)";
  if (speed && acceleration) return;
  if (speed || acceleration) {
    throw UsageError(
        fmt::format("no limit on {}, which the vehicle {} does not name either: give {}",
                    speed ? "acceleration" : "speed", vehicle, speed ? kAcceleration : kSpeed));
  }
  throw UsageError(fmt::format(
      "no limits on speed and acceleration, and the vehicle {} names none: give {} and {}", vehicle,
      kSpeed, kAcceleration));
}

}  // namespace

geom::Limits limits_to_check(const geom::LimitSources& sources, const std::string& vehicle) {
  const auto& asked = sources.options[Limit::tilt];
  const auto& held = sources.vehicle[Limit::tilt];
  if (sources.overridden && asked && held && *asked > *held) {
    throw UsageError(fmt::format(
        "tilt: asked for {:.10g} degrees, but the box of {} holds its body up to {:.10g} "
        "degrees only, which --override cannot change: name a --vehicle whose profile "
        "allows that tilt",
        *asked / kRadiansPerDegree, vehicle, *held / kRadiansPerDegree));
  }
  return geom::limits_that_hold(sources);
}

geom::Limits limits_to_solve(const geom::Limits& asked, const geom::Vehicle& vehicle) {
  if (const auto above = geom::first_above(asked, vehicle.limits)) {
    const geom::LimitKind& kind = geom::kind_of(*above);
    throw UsageError(fmt::format(
        "{}: asked for {}, but the vehicle {} may do at most {}: ask for no more, or name a "
        "--vehicle that may",
        kind.name, shown(kind, *asked[*above]), vehicle.name,
        shown(kind, *vehicle.limits[*above])));
  }
  const geom::Limits limits = geom::limits_that_hold({asked, {}, vehicle.limits});
  require_speed_and_acceleration(limits, vehicle.name);
  return limits;
}

}  // namespace cli
