#include "traj/flight/quadrotor.h"

#include "traj/proof/limits.h"

namespace traj {
namespace {

// state + h * derivative, member by member.
QuadrotorState advanced(const QuadrotorState& s, const QuadrotorState& d, double h) {
  QuadrotorState out;
  out.position = s.position + h * d.position;
  out.velocity = s.velocity + h * d.velocity;
  out.attitude.coeffs() = s.attitude.coeffs() + h * d.attitude.coeffs();
  out.body_rates = s.body_rates + h * d.body_rates;
  out.thrust = s.thrust + h * d.thrust;
  return out;
}

}  // namespace

Vec3 torque_of(const Quadrotor& quadrotor, const Motors& t) {
  return {quadrotor.arm.y() * (-t[0] + t[1] + t[2] - t[3]),
          quadrotor.arm.x() * (-t[0] + t[1] - t[2] + t[3]),
          quadrotor.torque_per_thrust * (-t[0] - t[1] + t[2] + t[3])};
}

QuadrotorState derivative(const Quadrotor& quadrotor, const QuadrotorState& state,
                          const QuadrotorInput& input) {
  const Eigen::Quaterniond& q = state.attitude;
  const Vec3& w = state.body_rates;
  const Eigen::Matrix3d rotation = q.toRotationMatrix();
  const Vec3 air = rotation.transpose() * (state.velocity - input.wind);
  Vec3 force = -quadrotor.drag.cwiseProduct(air);
  force.z() += state.thrust.sum();
  QuadrotorState d;
  d.position = state.velocity;
  d.velocity = rotation * force / quadrotor.mass;
  d.velocity.z() -= kGravity;
  // q' = q (0, w) / 2
  d.attitude.w() = -0.5 * q.vec().dot(w);
  d.attitude.vec() = 0.5 * (q.w() * w + q.vec().cross(w));
  const Vec3 spin = quadrotor.inertia.cwiseProduct(w);
  d.body_rates =
      (torque_of(quadrotor, state.thrust) - w.cross(spin)).cwiseQuotient(quadrotor.inertia);
  d.thrust = (input.command - state.thrust) / quadrotor.motor_time_constant;
  return d;
}

QuadrotorState integrate(const Quadrotor& quadrotor, const QuadrotorState& state,
                         const QuadrotorInput& input, double h) {
  const QuadrotorState a = derivative(quadrotor, state, input);
  const QuadrotorState b = derivative(quadrotor, advanced(state, a, h / 2), input);
  const QuadrotorState c = derivative(quadrotor, advanced(state, b, h / 2), input);
  const QuadrotorState d = derivative(quadrotor, advanced(state, c, h), input);
  QuadrotorState out = advanced(state, a, h / 6);
  out = advanced(out, b, h / 3);
  out = advanced(out, c, h / 3);
  out = advanced(out, d, h / 6);
  out.attitude.normalize();
  return out;
}

double acceleration_bound(const Quadrotor& quadrotor, double air_speed) {
  return kGravity +
         (4 * quadrotor.motor_most + quadrotor.drag.maxCoeff() * air_speed) / quadrotor.mass;
}

}  // namespace traj
