#include "traj/flight/controller.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/example_quadrotor.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

using support::example_quadrotor;

// Rates under p alone: lag w'' + w' + p w = p wanted. With p = 1 / (2 lag) its damping is
// 1/sqrt(2).
TEST(CascadeController, RateLoopStepsAsTheClosedForm) {
  const Quadrotor q = example_quadrotor();
  const double lag = q.motor_time_constant;
  const double p = 1 / (2 * lag);
  Gains gains;
  gains.rates.p = Vec3::Constant(p);
  gains.attitude = Vec3::Zero();
  gains.tilt_max = 0.5;
  CascadeController controller(q, gains, {});
  QuadrotorState state;
  state.thrust = Motors::Constant(q.mass * kGravity / 4);
  state.body_rates.x() = 0.2;      // falls to 0 as the step response rises
  const double s = 1 / (2 * lag);  // poles at s (-1 +- i)
  for (long n = 0; n < 300; ++n) {
    const double t = static_cast<double>(n) * 1e-3;
    // w(0) = 0.2 and w'(0) = 0, as the motors lag.
    const double exact = 0.2 * std::exp(-s * t) * (std::cos(s * t) + std::sin(s * t));
    ASSERT_NEAR(state.body_rates.x(), exact, 0.006) << t;
    const Motors command = controller.command(
        n, {}, {state.position, state.velocity, state.attitude, state.body_rates});
    state = integrate(q, state, {command, Vec3::Zero()}, 1e-3);
  }
  EXPECT_FALSE(controller.take_saturated());
}

TEST(CascadeController, NeverAsksForMoreTiltThanItMay) {
  const Quadrotor q = example_quadrotor();
  Gains gains = nominal_gains(q, 0.3);
  CascadeController controller(q, gains, {});
  Reference far;
  far.position = {1000, 0, 0};
  QuadrotorState state;
  state.thrust = Motors::Constant(q.mass * kGravity / 4);
  double tilt = 0;
  for (long n = 0; n < 3000; ++n) {
    const Motors command = controller.command(
        n, far, {state.position, state.velocity, state.attitude, state.body_rates});
    state = integrate(q, state, {command, Vec3::Zero()}, 1e-3);
    if (n > 2000) tilt = std::max(tilt, std::acos((state.attitude * Vec3::UnitZ()).z()));
  }
  EXPECT_TRUE(controller.take_saturated());
  EXPECT_NEAR(tilt, 0.3, 0.01);
}

}  // namespace
}  // namespace traj
