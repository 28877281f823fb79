#include "traj/flight/quadrotor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "traj/scenes.h"
#include "support/example_quadrotor.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

using support::example_quadrotor;

QuadrotorState fly(const Quadrotor& q, QuadrotorState state, const QuadrotorInput& input,
                   double seconds, int steps) {
  for (int i = 0; i < steps; ++i) state = integrate(q, state, input, seconds / steps);
  return state;
}

TEST(Quadrotor, HoversWhereItsMotorsHoldTheWeight) {
  const Quadrotor q = example_quadrotor();
  QuadrotorState start;
  start.thrust = Motors::Constant(q.mass * kGravity / 4);
  const QuadrotorState end = fly(q, start, {start.thrust, Vec3::Zero()}, 10, 10000);
  EXPECT_LT(end.position.norm(), 1e-10);
  EXPECT_LT(end.velocity.norm(), 1e-11);
  EXPECT_EQ(end.body_rates, Vec3::Zero());
}

TEST(Quadrotor, FallsAsLinearDragHasIt) {
  const Quadrotor q = example_quadrotor();
  const QuadrotorState end = fly(q, {}, {}, 3, 3000);
  const double rate = q.drag.z() / q.mass;
  const double speed = kGravity / rate * (1 - std::exp(-3 * rate));
  EXPECT_NEAR(end.velocity.z(), -speed, 1e-10);
  EXPECT_NEAR(end.position.z(), -(kGravity * 3 - speed) / rate, 1e-10);
}

TEST(Quadrotor, MotorsLagByTheFirstOrder) {
  const Quadrotor q = example_quadrotor();
  const QuadrotorState end = fly(q, {}, {Motors(1, 2, 3, 4), Vec3::Zero()}, 0.05, 50);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(end.thrust[i], (i + 1) * (1 - std::exp(-0.05 / 0.03)), 1e-7);
  }
}

TEST(Quadrotor, TakesTheWindAsTheAirsVelocity) {
  Quadrotor q = example_quadrotor();
  q.drag = Vec3::Constant(0.4);
  QuadrotorState start;
  start.thrust = Motors::Constant(q.mass * kGravity / 4);
  const QuadrotorState end = fly(q, start, {start.thrust, Vec3(3, -2, 0)}, 2, 2000);
  const Vec3 wanted = Vec3(3, -2, 0) * (1 - std::exp(-2 * 0.4 / q.mass));
  EXPECT_LT((end.velocity - wanted).norm(), 1e-9);
}

TEST(Quadrotor, TorquesTurnAboutTheRightAxes) {
  const Quadrotor q = example_quadrotor();
  EXPECT_GT(torque_of(q, {0, 1, 1, 0}).x(), 0);  // the left ones: rolls right
  EXPECT_GT(torque_of(q, {0, 1, 0, 1}).y(), 0);  // the back ones: nose down
  EXPECT_GT(torque_of(q, {0, 0, 1, 1}).z(), 0);  // clockwise ones: turns left
  EXPECT_TRUE(torque_of(q, Motors::Ones()).isZero());
}

// A body without forces keeps its spin (in the world's axes) and the energy of its rotation.
TEST(Quadrotor, KeepsMomentumAndEnergyOfRotation) {
  const Quadrotor q = example_quadrotor();
  testing::Random random(7);
  for (int i = 0; i < 20; ++i) {
    QuadrotorState start;
    start.body_rates = random.vector(5);
    const QuadrotorState end = fly(q, start, {}, 5, 5000);
    const auto spin = [&](const QuadrotorState& s) {
      return Vec3(s.attitude * q.inertia.cwiseProduct(s.body_rates));
    };
    const auto energy = [&](const QuadrotorState& s) {
      return 0.5 * s.body_rates.dot(q.inertia.cwiseProduct(s.body_rates));
    };
    EXPECT_LT((spin(end) - spin(start)).norm(), 1e-8 * spin(start).norm()) << "case " << i;
    EXPECT_NEAR(energy(end), energy(start), 1e-9 * energy(start)) << "case " << i;
    EXPECT_NEAR(end.attitude.norm(), 1, 1e-15);
  }
}

// Without drag, what the body gains in energy it loses in height.
TEST(Quadrotor, KeepsEnergyInFreeFall) {
  Quadrotor q = example_quadrotor();
  q.drag.setZero();
  QuadrotorState start;
  start.velocity = {3, -1, 8};
  const QuadrotorState end = fly(q, start, {}, 4, 4000);
  const auto energy = [](const QuadrotorState& s) {
    return 0.5 * s.velocity.squaredNorm() + kGravity * s.position.z();
  };
  EXPECT_NEAR(energy(end), energy(start), 1e-9);
}

TEST(Quadrotor, IsIntegratedToTheFourthOrder) {
  const Quadrotor q = example_quadrotor();
  QuadrotorState start;
  start.velocity = {4, -3, 1};
  start.body_rates = {2, -1, 3};
  start.thrust = Motors(1, 2, 2.5, 1.5);
  const QuadrotorInput input{Motors(2, 2.1, 1.9, 2.05), Vec3(3, 1, -1)};
  const QuadrotorState exact = fly(q, start, input, 1, 8192);
  const auto error = [&](int steps) {
    const QuadrotorState s = fly(q, start, input, 1, steps);
    return (s.position - exact.position).norm() + (s.velocity - exact.velocity).norm() +
           s.attitude.angularDistance(exact.attitude) + (s.body_rates - exact.body_rates).norm();
  };
  double coarse = error(64);
  for (int steps = 128; steps <= 512; steps *= 2) {
    const double fine = error(steps);
    const double order = std::log2(coarse / fine);
    EXPECT_NEAR(order, 4, 0.35) << steps << " steps";
    coarse = fine;
  }
}

TEST(Quadrotor, AccelerationStaysBelowItsBound) {
  const Quadrotor q = example_quadrotor();
  testing::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    QuadrotorState s;
    s.velocity = random.vector(10);
    s.attitude.coeffs() << random.vector(1), random.number(-1, 1);
    s.attitude.normalize();
    for (double& t : s.thrust) t = random.number(0, q.motor_most);
    const Vec3 wind = random.vector(10);
    EXPECT_LE(derivative(q, s, {s.thrust, wind}).velocity.norm(),
              acceleration_bound(q, (s.velocity - wind).norm()));
  }
}

}  // namespace
}  // namespace traj
