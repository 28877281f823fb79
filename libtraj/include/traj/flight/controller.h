#pragma once

// The cascaded controller: position, velocity, attitude, body rates, motors, as in PX4.
//
// Example:
//   const traj::Quadrotor model;
//   traj::CascadeController controller(model, traj::nominal_gains(model, 0.6), {});
//   const traj::Reference above{.position = {0, 0, 1}};
//   const traj::Motors thrust = controller.command(0, above, traj::Measured{});

#include "traj/flight/pid.h"
#include "traj/flight/sensors.h"
#include "traj/flight/reference.h"

namespace traj {

// How often each loop runs, in milliseconds.
struct LoopPeriods {
  int position = 10;  // position and velocity; 100 Hz
  int attitude = 4;   // 250 Hz
};

class CascadeController {
 public:
  // `model` is what the controller believes of the vehicle, mass included.
  CascadeController(const Quadrotor& model, const Gains& gains, const LoopPeriods& periods);

  // One call a millisecond, `step` counted from 0: runs the loops whose turn it is and returns what
  // the motors shall give.
  Motors command(long step, const Reference& reference, const Measured& measured);

  // Whether anything was clipped since this was last asked.
  bool take_saturated();

 private:
  void follow(const Reference& reference, const Measured& measured);
  void orient(const Reference& reference, const Measured& measured);
  Motors turn(const Measured& measured);
  Vec3 limited_lift(const Vec3& acceleration);

  Quadrotor model_;
  Gains gains_;
  LoopPeriods periods_;
  Pid position_;
  Pid velocity_;
  Pid rates_;
  Vec3 lost_velocity_ = Vec3::Zero();      // m/s
  Vec3 lost_acceleration_ = Vec3::Zero();  // m/s2
  Vec3 lost_turn_ = Vec3::Zero();          // rad/s2
  Vec3 lift_ = Vec3(0, 0, 9.80665);        // m/s2: thrust over mass that is asked for
  Vec3 rate_reference_ = Vec3::Zero();
  Vec3 last_rates_ = Vec3::Zero();
  bool saturated_ = false;
};

}  // namespace traj
