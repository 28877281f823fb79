#pragma once

// The gains of the controllers, as a vehicle's profile or a table of another stack gives them.
//
// Example:
//   const traj::Gains gains = traj::nominal_gains(traj::Quadrotor{}, 0.6);  // rad of tilt
//   const auto older = traj::preset_gains("stack-a", gains);
//   assert(older && !traj::preset_gains("stack-z", gains));

#include <limits>
#include <optional>
#include <string_view>

#include "traj/flight/quadrotor.h"

namespace traj {

struct PidGains {
  Vec3 p = Vec3::Zero();
  Vec3 i = Vec3::Zero();
  Vec3 d = Vec3::Zero();
  double clip = std::numeric_limits<double>::infinity();  // of the output, each axis; > 0
};

// How much of the trajectory's own derivatives is added: 0 none, 1 all.
struct FeedForward {
  double velocity = 1;
  double acceleration = 1;
  double body_rates = 1;  // from the jerk (Mellinger and Kumar 2011, section III)
};

// The geometric controller's, over mass and inertia (Lee, Leok and McClamroch 2010, eq. 15 and 16).
struct GeometricGains {
  Vec3 position = Vec3::Zero();  // 1/s2
  Vec3 velocity = Vec3::Zero();  // 1/s
  Vec3 attitude = Vec3::Zero();  // 1/s2
  Vec3 rates = Vec3::Zero();     // 1/s
  Vec3 lead = Vec3::Zero();      // 1: on the measured angular acceleration, against the motors' lag
};

struct Gains {
  PidGains position;             // m -> m/s
  PidGains velocity;             // m/s -> m/s2
  Vec3 attitude = Vec3::Zero();  // rad -> rad/s, about the body's axes
  PidGains rates;                // rad/s -> rad/s2; d acts on what is measured
  FeedForward feed_forward;
  double tilt_max = 0.6;  // rad, of the thrust that is commanded
  GeometricGains geometric;
};

// Gains that follow from the motors' lag: rates of damping 0.8, where in roll and pitch the
// derivative gain makes the lag three times shorter; attitude and velocity each a quarter as fast as
// the next inner loop, and the position half as fast as the velocity.
Gains nominal_gains(const Quadrotor& quadrotor, double tilt_max);

// "stack-a" and "stack-b": the position and velocity tables of two older stacks, without
// feed-forward (they name none), on the vehicle's own attitude and rate loops. Nothing for another
// name.
std::optional<Gains> preset_gains(std::string_view name, const Gains& own);

}  // namespace traj
