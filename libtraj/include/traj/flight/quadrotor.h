#pragma once

// A rigid quadrotor with lagging motors and linear drag, and its integrator.
//
// Example:
//   const traj::Quadrotor quadrotor{.mass = 1};
//   traj::QuadrotorState state;
//   state.thrust = traj::Motors::Constant(geom::kGravity / 4);
//   state = traj::integrate(quadrotor, state, {.command = state.thrust}, 1e-3);
//   assert(state.velocity.norm() < 1e-12);  // it hovers
//
// ENU axes; body axes are x forward, y left, z up. SI units throughout.

#include <Eigen/Geometry>

#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;
using Motors = Eigen::Vector4d;  // N: 1 front right, 2 back left, 3 front left, 4 back right

// The motors stand at (+-arm.x, +-arm.y); 1 and 2 turn counterclockwise seen from above.
struct Quadrotor {
  double mass = 1;                                       // kg, > 0
  Vec3 inertia = Vec3::Ones();                           // kg m2 about the body's axes, > 0
  Eigen::Vector2d arm = Eigen::Vector2d::Constant(0.1);  // m, > 0
  double torque_per_thrust = 0.016;                      // m, > 0: about z
  double motor_time_constant = 0.02;                     // s, > 0
  double motor_least = 0;                                // N each
  double motor_most = 5;                                 // N each, > motor_least
  Vec3 drag = Vec3::Zero();                              // kg/s along the body's axes, >= 0
  Vec3 body_rate_max = Vec3(4, 4, 3);                    // rad/s, what may be commanded
};

struct QuadrotorState {
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  // turns body axes into ENU
  Vec3 body_rates = Vec3::Zero();                                // about the body's axes
  Motors thrust = Motors::Zero();
};

// What acts during a step; held from its start to its end.
struct QuadrotorInput {
  Motors command = Motors::Zero();  // the thrusts the motors run towards
  Vec3 wind = Vec3::Zero();         // velocity of the air
};

// Torque about the body's axes of these thrusts.
Vec3 torque_of(const Quadrotor& quadrotor, const Motors& thrust);

// The derivative of each member in time (the attitude's as coefficients of a quaternion):
// m v' = R (T z - D R^T (v - wind)) - m g, J w' = torque - w x J w, T' = (command - T) / lag.
// Rotor drag linear in the air's velocity: Faessler, Franchi and Scaramuzza 2018, eq. 3.
QuadrotorState derivative(const Quadrotor& quadrotor, const QuadrotorState& state,
                          const QuadrotorInput& input);

// One step of h seconds by the classical Runge-Kutta method of order 4; the quaternion is then
// brought back to length 1, which changes it by O(h^5).
QuadrotorState integrate(const Quadrotor& quadrotor, const QuadrotorState& state,
                         const QuadrotorInput& input, double h);

// An upper bound on |acceleration| while no motor gives more than its most and the air moves by at
// most `air_speed` (m/s) relative to the vehicle.
double acceleration_bound(const Quadrotor& quadrotor, double air_speed);

}  // namespace traj
