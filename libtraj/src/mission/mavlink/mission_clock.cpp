#include "mission_clock.h"

#include <algorithm>
#include <numbers>

namespace traj {
namespace {

constexpr double kSecondsPerTurn = 18;  // 20 degrees a second
constexpr double kUsual = 5;            // m/s, where no autopilot is known
constexpr double kUsualRise = 1;

double slowest(std::span<const Autopilot> autopilots, double Autopilot::*speed, double usual) {
  double out = usual;
  bool any = false;
  for (const Autopilot& one : autopilots) {
    if (one.*speed > 0) out = any ? std::min(out, one.*speed) : one.*speed;
    any = any || one.*speed > 0;
  }
  return out;
}

}  // namespace

MissionClock::MissionClock(std::span<const Autopilot> autopilots)
    : own_speed_(slowest(autopilots, &Autopilot::speed, kUsual)),
      climb_(slowest(autopilots, &Autopilot::climb, kUsualRise)),
      descent_(slowest(autopilots, &Autopilot::descent, kUsualRise)) {}

void MissionClock::go(const Vec3& way) {
  const double rise = way.z() > 0 ? way.z() / climb_ : -way.z() / descent_;
  seconds_ += std::max(way.head<2>().norm() / speed_, rise);
}

void MissionClock::turn(double turns, double radius) {
  seconds_ += turns * std::max(kSecondsPerTurn, 2 * std::numbers::pi * radius / speed_);
}

}  // namespace traj
