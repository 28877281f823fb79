#include "solve/nominal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "curve/portable_math.h"

namespace traj {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Infinite where nothing limits it.
double speed_along(const Vec3& leg, const Limits& limits) {
  const double length = leg.norm();
  if (length == 0) return kInfinity;
  double vmax = limits[Limit::speed].value_or(kInfinity);
  const auto share = [&](const std::optional<double>& limit, double part) {
    if (limit && part > 0) vmax = std::min(vmax, *limit * (length / part));
  };
  share(limits[Limit::horizontal_speed], leg.head<2>().norm());
  share(limits[Limit::vertical_speed], std::abs(leg.z()));
  return vmax;
}

}  // namespace

SpeedProfile nominal_profile(const Limits& limits, double length) {
  std::optional<double> amax = limits[Limit::acceleration];
  if (limits[Limit::tilt]) {
    // The largest ball around a = 0 in the cone of allowed a + g: its radius is g sin(tilt).
    const double t = tangent_below(*limits[Limit::tilt]);
    const double ball = kGravity * t / std::sqrt(1 + t * t);
    amax = std::min(amax.value_or(ball), ball);
  }
  if (limits[Limit::thrust]) {
    amax = std::min(amax.value_or(kInfinity), *limits[Limit::thrust] - kGravity);
  }
  double vmax = kInfinity;
  for (const auto& limit :
       {limits[Limit::speed], limits[Limit::horizontal_speed], limits[Limit::vertical_speed]}) {
    vmax = std::min(vmax, limit.value_or(kInfinity));
  }
  SpeedProfile profile;
  if (vmax < kInfinity) {
    profile.vmax = vmax;
  } else if (amax) {
    profile.vmax = std::max(1e-3, std::sqrt(*amax * length));
  } else {
    profile.vmax = 10;
  }
  profile.amax = amax.value_or(profile.vmax);
  return profile;
}

SpeedProfile along_leg(const Vec3& leg, const Limits& limits, const SpeedProfile& nominal) {
  const double vmax = speed_along(leg, limits);
  return {vmax < kInfinity ? vmax : nominal.vmax, nominal.amax};
}

std::optional<SpeedProfile> cruise_profile(const Vec3& leg, const Limits& limits) {
  const bool held = limits[Limit::acceleration] || limits[Limit::tilt] || limits[Limit::thrust];
  const double vmax = speed_along(leg, limits);
  if (!held || !(vmax < kInfinity)) return std::nullopt;
  return SpeedProfile{vmax, nominal_profile(limits, leg.norm()).amax};
}

}  // namespace traj
