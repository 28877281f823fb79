#include "traj/mission/mavlink/mission_time.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traj {
namespace {

constexpr double kMetresPerDegree = 6'371'000 * std::numbers::pi / 180;

// East, north and up of an item from another, m. On a sphere: to a percent.
Vec3 way_between(const MissionItem& from, const MissionItem& to) {
  const double north = (to.latitude - from.latitude) * kMetresPerDegree;
  const double east = (to.longitude - from.longitude) * kMetresPerDegree *
                      std::cos(from.latitude * std::numbers::pi / 180);
  return {east, north, to.altitude - from.altitude};
}

// The speed along the way at which it climbs or sinks no faster than the autopilot lets it, m/s.
double speed_along(const Vec3& way, double speed, const Autopilot& autopilot) {
  const double rise = std::abs(way.z());
  if (rise == 0) return speed;
  return std::min(speed, (way.z() > 0 ? autopilot.climb : autopilot.descent) * way.norm() / rise);
}

}  // namespace

double rest_to_rest(double length, double speed, double acceleration, double jerk) {
  if (length <= 0) return 0;
  // A peak speed v takes v / acceleration + acceleration / jerk seconds and as many metres times
  // v / 2, on either side; below acceleration^2 / jerk the acceleration is not reached.
  const double least = acceleration * acceleration / jerk;
  const double ramp = acceleration / jerk;
  const double peak =
      acceleration * (std::sqrt(ramp * ramp + 4 * length / acceleration) - ramp) / 2;
  if (std::min(peak, speed) >= least) {
    const double v = std::min(peak, speed);
    return length / v + v / acceleration + ramp;
  }
  const double reached = std::cbrt(length * length * jerk / 4);  // by jerk alone
  const double v = std::min(reached, speed);
  return length / v + 2 * std::sqrt(v / jerk);
}

MissionTime mission_time(const Mission& mission, const Autopilot& autopilot) {
  MissionTime out;
  const MissionItem* before = nullptr;
  double speed = autopilot.speed;
  double length = 0;       // since the last rest
  double slowest = speed;  // of the legs since then
  for (const MissionItem& item : mission.items) {
    if (item.command == kSpeed && item.param[1] > 0) speed = item.param[1];
    if (item.command != kTakeoff && item.command != kWaypoint) continue;
    if (before) {
      const Vec3 way = way_between(*before, item);
      const double along = speed_along(way, speed, autopilot);
      slowest = length == 0 ? along : std::min(slowest, along);
      length += way.norm();
      ++out.waypoints;
    }
    before = &item;
    if (!(item.param[0] > 0)) continue;
    out.seconds += rest_to_rest(length, slowest, autopilot.acceleration, autopilot.jerk);
    out.seconds += item.param[0];
    out.rests += 1;
    length = 0;
  }
  out.seconds += rest_to_rest(length, slowest, autopilot.acceleration, autopilot.jerk);
  return out;
}

}  // namespace traj
