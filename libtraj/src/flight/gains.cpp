#include "traj/flight/gains.h"

#include <cmath>

namespace traj {
namespace {

// Closed by a motor of lag T, rates under p and d obey T w'' + (1 + d) w' + p w = p w_wanted.
constexpr double kDamping = 0.8;
constexpr double kRateDerivative = 2;
constexpr double kSeparation = 4;

}  // namespace

Gains nominal_gains(const Quadrotor& quadrotor, double tilt_max) {
  const double lag = quadrotor.motor_time_constant;
  // With the derivative gain d, damping is (1 + d) / (2 sqrt(lag p)).
  const auto rate_gain = [&](double d) {
    return (1 + d) * (1 + d) / (4 * kDamping * kDamping * lag);
  };
  const double p = rate_gain(kRateDerivative);
  const double yaw = rate_gain(0);  // motors turn a vehicle weakly: no derivative of noise
  const double turn = std::sqrt(p / lag) / kSeparation;  // rad/s, of the attitude loop
  const double speed = turn / kSeparation;
  Gains gains;
  gains.rates = {Vec3(p, p, yaw), Vec3(p, p, yaw), Vec3(kRateDerivative, kRateDerivative, 0)};
  gains.attitude = Vec3(turn, turn, std::sqrt(yaw / lag) / kSeparation);
  gains.velocity = {Vec3(speed, speed, 2 * speed), Vec3::Constant(speed / 2), Vec3::Zero()};
  gains.position.p = Vec3::Constant(speed / 2);
  gains.tilt_max = tilt_max;
  GeometricGains& geometric = gains.geometric;
  geometric.velocity = gains.velocity.p;
  geometric.position = gains.velocity.p.cwiseProduct(gains.position.p);
  // The same inner loops as the cascade's.
  geometric.rates = gains.rates.p;
  geometric.attitude = gains.rates.p.cwiseProduct(gains.attitude);
  geometric.lead = gains.rates.d;
  return gains;
}

std::optional<Gains> preset_gains(std::string_view name, const Gains& own) {
  Gains gains = own;
  gains.feed_forward = {0, 0, 0};
  if (name == "stack-a") {
    gains.position = {{0.8, 0.8, 1.0}, Vec3::Zero(), {0.4, 0.4, 0.45}, 10};
    gains.velocity = {{1.5, 1.5, 2.0}, {0.1, 0.1, 0.1}, {0.4, 0.4, 0.5}, 5};
    gains.tilt_max = 0.5;  // "maximum actuation", taken as radians of tilt
    return gains;
  }
  if (name == "stack-b") {
    gains.position = {{0.1, 0.1, 0.01}, Vec3::Zero(), Vec3::Zero()};
    gains.velocity = {{2, 2, 20}, {0, 0, 0.01}, {0.1, 0, 0.1}};
    return gains;
  }
  return std::nullopt;
}

}  // namespace traj
