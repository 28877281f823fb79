#include "flight/motor_mixer.h"

#include <algorithm>

namespace traj {
namespace {

// By how much each motor's thrust changes for a torque; they add to no thrust.
Motors of_torque(const Quadrotor& q, const Vec3& torque) {
  const double x = torque.x() / (4 * q.arm.y());
  const double y = torque.y() / (4 * q.arm.x());
  const double z = torque.z() / (4 * q.torque_per_thrust);
  return {-x - y - z, x + y - z, x - y + z, -x + y + z};
}

double spread(const Motors& m) { return m.maxCoeff() - m.minCoeff(); }

// The mean thrust nearest to what is wanted that keeps every motor within its range. A turn that
// takes all of the room leaves one mean only, and rounding may put its two bounds the wrong way
// round by an ulp.
double mean_within_room(const Quadrotor& q, double wanted, const Motors& turn) {
  const double least = q.motor_least - turn.minCoeff();
  const double most = q.motor_most - turn.maxCoeff();
  return least < most ? std::clamp(wanted, least, most) : 0.5 * (least + most);
}

}  // namespace

Mixed mix(const Quadrotor& q, double thrust, const Vec3& torque) {
  const double room = q.motor_most - q.motor_least;
  Mixed out;
  Motors tilt = of_torque(q, {torque.x(), torque.y(), 0});
  const Motors yaw = of_torque(q, {0, 0, torque.z()});
  double kept = 1;
  if (spread(tilt + yaw) > room) {
    // The spread is convex in the share of yaw: what is surely within the room.
    kept = std::clamp((room - spread(tilt)) / spread(yaw), 0.0, 1.0);
    out.saturated = true;
  }
  Motors turn = tilt + kept * yaw;
  if (spread(turn) > room) turn *= room / spread(turn);
  const double mean = mean_within_room(q, thrust / 4, turn);
  out.saturated |= mean != thrust / 4;
  out.command = (turn.array() + mean).max(q.motor_least).min(q.motor_most);
  out.thrust = out.command.sum();
  out.torque = out.saturated ? torque_of(q, out.command) : torque;
  return out;
}

}  // namespace traj
