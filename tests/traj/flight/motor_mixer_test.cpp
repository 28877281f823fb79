// With motor_mixer.cpp compiled with the assertions of the standard library, as a sanitizer build
// has it: a clamp between bounds that are the wrong way round ends the program.

#include "traj/flight/motor_mixer.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace traj
