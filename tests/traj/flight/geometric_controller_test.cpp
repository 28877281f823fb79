#include "flight/geometric_controller.h"

#include <gtest/gtest.h>

#include "support/example_quadrotor.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

using support::example_quadrotor;

// All different, without lead.
Gains some_gains() {
  Gains gains;
  gains.geometric.position = {1, 2, 3};
  gains.geometric.velocity = {4, 5, 6};
  gains.geometric.attitude = {7, 8, 9};
  gains.geometric.rates = {10, 11, 12};
  return gains;
}

Motors first_command(const Gains& gains, const Reference& reference, const Measured& measured) {
  return GeometricController(example_quadrotor(), gains, {}).command(0, reference, measured);
}

TEST(GeometricController, HoldsTheWeightWhereItShouldBe) {
  const Quadrotor q = example_quadrotor();
  const Motors command = first_command(some_gains(), {}, {});
  EXPECT_LT((command - Motors::Constant(q.mass * kGravity / 4)).norm(), 1e-12);
}

// Equation 15 on the vertical, where the attitude asks for nothing.
TEST(GeometricController, ThrustIsThatOfHeightAndClimb) {
  const Quadrotor q = example_quadrotor();
  Reference above;
  above.position.z() = 0.5;
  above.acceleration.z() = 0.25;
  Measured climbing;
  climbing.velocity.z() = 0.125;
  EXPECT_NEAR(first_command(some_gains(), above, climbing).sum(),
              q.mass * (kGravity + 3 * 0.5 - 6 * 0.125 + 0.25), 1e-12);
}

// Equation 16 about one axis: the gyroscopic terms are none.
TEST(GeometricController, TorqueIsThatOfRatesAndSmallTurns) {
  const Quadrotor q = example_quadrotor();
  for (int k = 0; k < 3; ++k) {
    Measured turning;
    turning.body_rates[k] = 0.1;
    Vec3 torque = torque_of(q, first_command(some_gains(), {}, turning));
    Vec3 expected = Vec3::Zero();
    expected[k] = -q.inertia[k] * some_gains().geometric.rates[k] * 0.1;
    EXPECT_LT((torque - expected).norm(), 1e-12) << "axis " << k;
    Measured turned;
    turned.attitude = Eigen::AngleAxisd(0.01, Vec3::Unit(k));
    torque = torque_of(q, first_command(some_gains(), {}, turned));
    expected[k] = -q.inertia[k] * some_gains().geometric.attitude[k] * std::sin(0.01);
    EXPECT_LT((torque - expected).norm(), 1e-12) << "axis " << k;
  }
}

TEST(GeometricController, TiltsTowardsWhereItShouldBe) {
  Reference east;
  east.position.x() = 1;
  const Vec3 torque = torque_of(example_quadrotor(), first_command(some_gains(), east, {}));
  EXPECT_GT(torque.y(), 0) << "nose down";
  EXPECT_NEAR(torque.x(), 0, 1e-12);
}

TEST(GeometricController, LeadOpposesTheAngularAcceleration) {
  Gains gains = some_gains();
  const auto roll = [&] {
    GeometricController controller(example_quadrotor(), gains, {});
    controller.command(0, {}, {});
    Measured spinning;
    spinning.body_rates.x() = 0.01;
    return torque_of(example_quadrotor(), controller.command(1, {}, spinning)).x();
  };
  const double without = roll();
  gains.geometric.lead = Vec3::Ones();
  EXPECT_LT(roll(), without);
}

TEST(GeometricController, SaysOnceThatItWasClipped) {
  GeometricController controller(example_quadrotor(), some_gains(), {});
  Reference high;
  high.position.z() = 1000;
  controller.command(0, high, {});
  EXPECT_TRUE(controller.take_saturated());
  EXPECT_FALSE(controller.take_saturated());
}

// Thrust and attitude are asked for every few milliseconds only.
TEST(GeometricController, HeedsTheReferenceAtTheAttitudeLoopsRate) {
  GeometricController controller(example_quadrotor(), some_gains(), {10, 4});
  Reference above;
  above.position.z() = 0.5;
  const double hover = controller.command(0, {}, {}).sum();
  for (long step = 1; step < 4; ++step) {
    EXPECT_NEAR(controller.command(step, above, {}).sum(), hover, 1e-12) << step;
  }
  EXPECT_GT(controller.command(4, above, {}).sum(), hover + 0.1);
}

}  // namespace
}  // namespace traj
