#include "traj/flight/pid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

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

TEST(Pid, LowPassesTheDerivativeAndAddsWhatIsGiven) {
  const double period = 0.01;
  const double filter = 0.04;  // a share of 0.2 a call
  Pid pid({Vec3::Zero(), Vec3::Zero(), Vec3::Constant(2)}, period, filter);
  double left = 1;
  for (int n = 0; n < 20; ++n) {
    left *= 0.8;
    const Vec3 out = pid.update(Vec3::Zero(), Vec3(1, 0, 0), Vec3(0, 5, 0), Vec3::Zero());
    EXPECT_NEAR(out.x(), 2 * (1 - left), 1e-12) << n;
    EXPECT_EQ(out.y(), 5);
  }
  EXPECT_FALSE(pid.clipped());
}

}  // namespace
}  // namespace traj
