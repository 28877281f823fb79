#pragma once

// The geometric tracking controller on SE(3), to compare with the cascade.

#include "traj/flight/controller.h"

namespace traj {

// Lee, Leok and McClamroch 2010, eq. 12, 15 and 16, with the desired body rates by flatness from
// the trajectory's jerk and without their derivative. One thing is added, since these equations
// know no motor lag: the measured angular acceleration, low-passed at 30 Hz, times -`lead`. Thrust
// and attitude are asked for at the attitude loop's rate, torques at 1 kHz.
class GeometricController {
 public:
  GeometricController(const Quadrotor& model, const Gains& gains, const LoopPeriods& periods);

  Motors command(long step, const Reference& reference, const Measured& measured);
  bool take_saturated();

 private:
  Quadrotor model_;
  Gains gains_;
  int period_;
  Vec3 lift_ = Vec3(0, 0, 9.80665);
  Eigen::Matrix3d wanted_ = Eigen::Matrix3d::Identity();
  Vec3 wanted_rates_ = Vec3::Zero();
  Vec3 last_rates_ = Vec3::Zero();
  Vec3 angular_acceleration_ = Vec3::Zero();  // low-passed
  bool saturated_ = false;
};

}  // namespace traj
