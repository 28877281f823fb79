// With motor_mixer.cpp compiled with the assertions of the standard library, as a sanitizer build
// has it: a clamp between bounds that are the wrong way round ends the program.

#include "flight/motor_mixer.h"

#include <gtest/gtest.h>

#include "support/example_quadrotor.h"
#include "traj/scenes.h"

namespace traj {
namespace {

Quadrotor quadrotor(double least, double most) {
  Quadrotor q;
  q.mass = 1.5;
  q.motor_least = least;
  q.motor_most = most;
  q.arm = {0.13, 0.17};
  q.torque_per_thrust = 0.0137;
  return q;
}

TEST(MotorMixer, FindsAMeanWhereTheTurnTakesAllRoom) {
  testing::Random random(7);
  for (int i = 0; i < 200000; ++i) {
    const double least = random.number(0, 0.5);
    const Quadrotor q = quadrotor(least, least + random.number(0.1, 9));
    const Vec3 torque = random.vector(i % 2 ? 3 : 300);
    const Mixed mixed = mix(q, random.number(-10, 60), torque);
    ASSERT_GE(mixed.command.minCoeff(), q.motor_least) << "case " << i;
    ASSERT_LE(mixed.command.maxCoeff(), q.motor_most) << "case " << i;
    ASSERT_TRUE(mixed.torque.allFinite()) << "case " << i;
  }
}

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

}  // namespace
}  // namespace traj
