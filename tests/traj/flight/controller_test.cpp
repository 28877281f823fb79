#include "traj/flight/controller.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/example_quadrotor.h"
#include "traj/flight/attitude.h"
#include "traj/flight/motor_mixer.h"
#include "traj/proof/limits.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::example_quadrotor;

TEST(MotorMixer, GivesWhatIsAskedWhereItCan) {
  testing::Random random(1);
  const Quadrotor q = example_quadrotor();
  int kept = 0;
  for (int i = 0; i < 1000; ++i) {
    const double thrust = random.number(2, 9);
    const Vec3 torque = random.vector(0.03);
    const Mixed mixed = mix(q, thrust, torque);
    ASSERT_GE(mixed.command.minCoeff(), q.motor_least) << "case " << i;
    ASSERT_LE(mixed.command.maxCoeff(), q.motor_most) << "case " << i;
    if (mixed.saturated) continue;
    ++kept;
    EXPECT_NEAR(mixed.command.sum(), thrust, 1e-12);
    EXPECT_LT((torque_of(q, mixed.command) - torque).norm(), 1e-13);
  }
  EXPECT_GT(kept, 300);
  EXPECT_LT(kept, 1000);
}

TEST(MotorMixer, GivesUpYawThenThrustThenTilt) {
  const Quadrotor q = example_quadrotor();
  const Mixed yaw = mix(q, 8, {0.1, 0, 1});
  EXPECT_TRUE(yaw.saturated);
  EXPECT_NEAR(yaw.torque.x(), 0.1, 1e-12);
  EXPECT_LT(yaw.torque.z(), 1);
  const Mixed thrust = mix(q, 40, {0.1, 0.05, 0});
  EXPECT_NEAR(thrust.torque.x(), 0.1, 1e-12);
  EXPECT_NEAR(thrust.torque.y(), 0.05, 1e-12);
  EXPECT_LT(thrust.thrust, 4 * q.motor_most);
  const Mixed tilt = mix(q, 6, {10, 0, 0});
  EXPECT_NEAR(tilt.torque.x(), 2 * q.arm[1] * (q.motor_most - q.motor_least), 1e-12);
  const Mixed nothing = mix(q, 0, Vec3::Zero());
  EXPECT_EQ(nothing.command, Motors::Constant(q.motor_least));
  EXPECT_TRUE(nothing.saturated);
}

// An integrator under p and i obeys x'' + p x' + i x = i wanted (+ p wanted').
TEST(Pid, FollowsTheClosedFormOfAnIntegrator) {
  const double p = 3;
  const double i = 2;  // poles at -1 and -2
  const double h = 1e-3;
  Pid pid({Vec3::Constant(p), Vec3::Constant(i), Vec3::Zero()}, h, 0);
  Vec3 x = Vec3::Zero();
  for (int n = 0; n < 3000; ++n) {
    // x(t) = 1 + e^-t - 2 e^-2t: rises past 1 by its zero.
    const double t = n * h;
    ASSERT_NEAR(x[0], 1 + std::exp(-t) - 2 * std::exp(-2 * t), 3e-3) << t;
    x += h * pid.update(Vec3::Ones() - x, Vec3::Zero(), Vec3::Zero());
  }
}

TEST(Pid, TakesTheDerivativeOfTheError) {
  Pid pid({Vec3::Zero(), Vec3::Zero(), Vec3::Constant(2)}, 0.01, 0);
  EXPECT_EQ(pid.update(Vec3(5, 5, 5), Vec3::Zero(), Vec3::Zero()), Vec3::Zero());
  EXPECT_TRUE(pid.update(Vec3(5.1, 5, 4.9), Vec3::Zero(), Vec3::Zero()).isApprox(Vec3(20, 0, -20)));
}

TEST(Pid, DoesNotWindUpWhileItIsClipped) {
  PidGains gains{Vec3::Constant(1), Vec3::Constant(1), Vec3::Zero(), 0.5};
  Pid pid(gains, 0.01, 0);
  for (int n = 0; n < 1000; ++n) {
    EXPECT_EQ(pid.update(Vec3(10, -10, 0.1), Vec3::Zero(), Vec3::Zero())[0], 0.5);
  }
  EXPECT_TRUE(pid.clipped());
  EXPECT_EQ(pid.integral()[0], 0);
  EXPECT_EQ(pid.integral()[1], 0);
  EXPECT_NEAR(pid.integral()[2], 0.4, 1.1e-3);  // up to the clip and no further
  // Wound down at once when the error turns.
  pid.update(Vec3(-0.3, 0.3, -0.3), Vec3::Zero(), Vec3::Zero());
  EXPECT_LT(pid.integral()[0], 0);
}

TEST(Pid, StandsStillWhereLaterLimitsTakeItsOutput) {
  Pid pid({Vec3::Zero(), Vec3::Ones(), Vec3::Zero()}, 0.01, 0);
  for (int n = 0; n < 100; ++n) pid.update(Vec3(1, 1, -1), Vec3::Zero(), Vec3(0.2, -0.2, 0));
  EXPECT_EQ(pid.integral()[0], 0);
  EXPECT_NEAR(pid.integral()[1], 1, 1e-12);
  EXPECT_NEAR(pid.integral()[2], -1, 1e-12);
}

TEST(Attitude, ErrorIsTheRotationThatIsLeft) {
  const Eigen::Quaterniond now(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  const Eigen::Quaterniond tilted = now * Eigen::AngleAxisd(0.01, Vec3(0.6, 0.8, 0));
  EXPECT_LT((attitude_error(now, tilted, 0.4) - Vec3(0.006, 0.008, 0)).norm(), 1e-6);
  const Eigen::Quaterniond turned = now * Eigen::AngleAxisd(0.01, Vec3::UnitZ());
  EXPECT_LT((attitude_error(now, turned, 0.4) - Vec3(0, 0, 0.004)).norm(), 1e-6);
  EXPECT_LT((attitude_error(now, turned, 1) - Vec3(0, 0, 0.01)).norm(), 1e-6);
  Eigen::Quaterniond same = now;
  same.coeffs() *= -1;
  EXPECT_LT(attitude_error(now, same, 1).norm(), 1e-12);
}

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
