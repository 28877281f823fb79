#include "curve/bernstein.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(DerivativePoints, EndWithTheEndStates) {
  testing::Random random(3);
  const Segment s = random.segment();
  const State begin = evaluate(s, 0);
  const State end = evaluate(s, s.duration);
  EXPECT_EQ(velocity_points(s).front(), begin.velocity);
  EXPECT_EQ(velocity_points(s).back(), end.velocity);
  EXPECT_EQ(acceleration_points(s).front(), begin.acceleration);
  EXPECT_EQ(jerk_points(s).back(), end.jerk);
}

TEST(Split, HalvesFollowTheSameCurve) {
  testing::Random random(4);
  for (int i = 0; i < 50; ++i) {
    Segment s = random.segment();
    s.yaw = std::array<double, kPoints>{0, 1, 2, 3, 4, 5, 6, 7};
    const auto [left, right] = split(s);
    EXPECT_EQ(left.duration + right.duration, s.duration);
    EXPECT_EQ(left.point.back(), right.point.front());
    EXPECT_EQ(left.yaw->back(), 3.5);
    const double t = random.number(0, s.duration / 2);
    EXPECT_LT((evaluate(left, t).position - evaluate(s, t).position).norm(), 1e-12);
    const double later = t + s.duration / 2;
    EXPECT_LT((evaluate(right, t).position - evaluate(s, later).position).norm(), 1e-12);
  }
}

TEST(SnapCost, OfAQuarticIsItsConstantSnapSquaredTimesDuration) {
  // x = t^4 over 2 s: snap 24, so 24^2 * 2.
  const Segment s =
      hermite({}, {Vec3(16, 0, 0), Vec3(32, 0, 0), Vec3(48, 0, 0), Vec3(48, 0, 0)}, 2);
  EXPECT_NEAR(snap_cost(s), 1152, 1e-8);
}

TEST(SnapCost, OfTheHalvesAddsUp) {
  testing::Random random(5);
  const Segment s = random.segment();
  const auto [left, right] = split(s);
  EXPECT_NEAR(snap_cost(left) + snap_cost(right), snap_cost(s), 1e-9 * snap_cost(s));
  EXPECT_DOUBLE_EQ(snap_cost(Trajectory{{left, right}}), snap_cost(left) + snap_cost(right));
}

}  // namespace
}  // namespace traj
