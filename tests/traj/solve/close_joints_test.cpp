#include "traj/solve/close_joints.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::Random;

Trajectory with_gap(Random& random, const State& gap) {
  const State middle = random.state(5);
  State other = middle;
  other.position += gap.position;
  other.velocity += gap.velocity;
  other.acceleration += gap.acceleration;
  other.jerk += gap.jerk;
  return {{hermite(random.state(5), middle, 2.5), hermite(other, random.state(5), 1.5)}};
}

TEST(CloseJoints, MakesSegmentsMeetAndMovesThemNoFurtherThanTheGap) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const Trajectory t = with_gap(
        random, {random.vector(4e-4), random.vector(4e-3), random.vector(4e-2), random.vector(1)});
    const ClosedJoints closed = close_joints(t, 1e-3, "c.csv");
    const Trajectory& c = closed.trajectory;
    const State end = evaluate(c.segments[0], 2.5);
    const State begin = evaluate(c.segments[1], 0);
    EXPECT_LT((end.position - begin.position).norm(), 1e-12);
    EXPECT_LT((end.velocity - begin.velocity).norm(), 1e-11);
    EXPECT_LT((end.acceleration - begin.acceleration).norm(), 1e-10);
    EXPECT_GT(closed.largest_gap, 0);
    for (double s = 0; s < 4; s += 0.05) {
      EXPECT_LT((evaluate(c, s).position - evaluate(t, s).position).norm(), 0.02) << "case " << i;
    }
    EXPECT_LT((evaluate(c, 0).position - evaluate(t, 0).position).norm(), 1e-12);
  }
}

TEST(CloseJoints, MakesYawAndItsRateMeetAcrossWholeTurns) {
  Random random(10);
  Trajectory t = with_gap(random, {});
  t.segments[0].yaw = {0, 0, 0, 0, 1, 2, 3.0, 3.1};
  t.segments[1].yaw = {-3.18, -3.12, -3, -2, -1, 0, 0, 0};  // a turn back, and 3.2 mrad
  EXPECT_THROW(close_joints(t, 1e-3, "c.csv"), geom::InputError);
  const ClosedJoints closed = close_joints(t, 5e-3, "c.csv");
  const auto& a = *closed.trajectory.segments[0].yaw;
  const auto& b = *closed.trajectory.segments[1].yaw;
  EXPECT_DOUBLE_EQ(a[7], b[0]);
  EXPECT_NEAR(b[0], 3.1016, 1e-4);
  EXPECT_NEAR((a[7] - a[6]) / 2.5, (b[1] - b[0]) / 1.5, 1e-12);
}

TEST(CloseJoints, RefusesAJumpWithSegmentTimeAndGap) {
  Random random(9);
  const Trajectory apart = with_gap(random, {{0.2, 0, 0}});
  EXPECT_EQ(support::refusal_of([&] { close_joints(apart, 1e-3, "c.csv"); }),
            "c.csv: a jump: position steps by 0.2 m where segment 1 begins, at t = 2.5 s; expected "
            "at most 0.001");
  EXPECT_THROW(close_joints(with_gap(random, {Vec3::Zero(), {0.02, 0, 0}}), 1e-3, "c.csv"),
               geom::InputError);
  EXPECT_THROW(
      close_joints(with_gap(random, {Vec3::Zero(), Vec3::Zero(), {0.2, 0, 0}}), 1e-3, "c.csv"),
      geom::InputError);
}

}  // namespace
}  // namespace traj
