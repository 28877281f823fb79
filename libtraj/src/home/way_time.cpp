#include "home/way_time.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"

namespace traj {
namespace {

// m/s: what ArduPilot sinks with near the ground (LAND_SPEED); PX4 is faster (MPC_LAND_SPEED).
constexpr double kLandingSpeed = 0.5;

// Seconds that speeding up and slowing down cost: an S-curve takes v / a + a / j, half of it lost.
double ramp(const ReturnModel& model, double speed) {
  return speed / model.deceleration + model.deceleration / model.jerk;
}

WaySpeeds way_speeds(const ReturnModel& model, const geom::Limits& limits,
                     const std::optional<Energy>& energy) {
  WaySpeeds out{model.speed, model.speed, model.climb, model.descent};
  for (const geom::Limit limit : {geom::Limit::speed, geom::Limit::horizontal_speed}) {
    if (limits[limit]) out.across = std::min(out.across, *limits[limit]);
  }
  for (const geom::Limit limit : {geom::Limit::speed, geom::Limit::vertical_speed}) {
    if (!limits[limit]) continue;
    out.climb = std::min(out.climb, *limits[limit]);
    out.descent = std::min(out.descent, *limits[limit]);
  }
  out.fastest = out.across;
  if (!energy) return out;
  out.across -= energy->wind;
  if (out.across > 0) return out;
  throw geom::InputError(
      model.autopilot,
      {.says =
           fmt::format("a wind of {} m/s is not slower than the vehicle, {} m/s on its way home",
                       energy->wind, out.fastest),
       .advice = "it would not come home: give less wind_m_s, or a faster return"});
}

double braking_time(const ReturnModel& model, double speed) {
  return model.reaction + model.overshoot_time + ramp(model, speed);
}

// From rest to rest.
double leg_time(const ReturnModel& model, const WaySpeeds& speeds, const Vec3& a, const Vec3& b) {
  const Vec3 leg = b - a;
  const double rise = leg.z() > 0 ? leg.z() / speeds.climb : -leg.z() / speeds.descent;
  return leg.head<2>().norm() / speeds.across + rise + ramp(model, speeds.fastest);
}

}  // namespace

WayTime::WayTime(std::span<const ReturnModel> models, const geom::Limits& limits,
                 const std::optional<Energy>& energy)
    : models_(models) {
  for (const ReturnModel& model : models) speeds_.push_back(way_speeds(model, limits, energy));
}

double WayTime::at_most(const Braking& from, const geom::Polyline& points) const {
  double most = 0;
  for (std::size_t i = 0; i < models_.size(); ++i) {
    double join = 0;
    for (const Vec3& p : from.corners) {
      join = std::max(join, leg_time(models_[i], speeds_[i], p, points.front()));
    }
    double along = (points[points.size() - 2].z() - points.back().z()) / kLandingSpeed;
    for (std::size_t leg = 1; leg + 1 < points.size(); ++leg) {
      along += leg_time(models_[i], speeds_[i], points[leg - 1], points[leg]);
    }
    most = std::max(most, braking_time(models_[i], from.speed) + join + along);
  }
  return most;
}

}  // namespace traj
