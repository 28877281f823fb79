#include "solve/time_scaling.h"

#include <gtest/gtest.h>

#include "traj/proof/check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::random_trajectory;

TEST(Slowed, KeepsTheCurveAndDividesTheSpeed) {
  const Trajectory t = random_trajectory(1);
  const Trajectory slow = slowed(t, 2);
  EXPECT_DOUBLE_EQ(duration(slow), 2 * duration(t));
  for (std::size_t i = 0; i < t.segments.size(); ++i) {
    EXPECT_EQ(slow.segments[i].point, t.segments[i].point);
  }
  const State fast = evaluate(t, 1.1);
  EXPECT_LT((evaluate(slow, 2.2).velocity - fast.velocity / 2).norm(), 1e-10);
}

// Samples bound the factor from below, the check from above.
TEST(SmallestFactor, MakesEachLimitJustHold) {
  const geom::CollisionScene empty =
      testing::scene_of({}, {Vec3::Constant(-1e4), Vec3::Constant(1e4)});
  const std::vector<Limits> cases{
      {{Limit::speed, 5}},
      {{Limit::acceleration, 3}},
      {{Limit::jerk, 7}},
      {{Limit::tilt, 0.4}},
      {{Limit::speed, 5}, {Limit::acceleration, 3}, {Limit::jerk, 7}, {Limit::tilt, 0.4}},
      {{Limit::horizontal_speed, 4}},
      {{Limit::vertical_speed, 2}},
      {{Limit::thrust, 12}},
      {{Limit::tilt, 0.3},
       {Limit::horizontal_speed, 4},
       {Limit::vertical_speed, 1},
       {Limit::thrust, 11}}};
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trajectory t = random_trajectory(seed);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const double factor = smallest_factor(t, cases[i]);
      EXPECT_TRUE(check(empty, slowed(t, factor), cases[i]).ok) << "seed " << seed << " case " << i;
      EXPECT_FALSE(check(empty, slowed(t, factor * (1 - 2e-6)), cases[i]).ok)
          << "seed " << seed << " case " << i;
    }
  }
}

TEST(SmallestFactor, HoldsTheRateAtWhichTheThrustTurns) {
  const geom::CollisionScene empty =
      testing::scene_of({}, {Vec3::Constant(-1e4), Vec3::Constant(1e4)});
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trajectory t = random_trajectory(seed);
    const Limits limits{{Limit::speed, 5}, {Limit::body_rate, 0.5}};
    const double factor = smallest_factor(t, limits);
    EXPECT_GE(factor, smallest_factor(t, {{Limit::speed, 5}}));
    EXPECT_TRUE(check(empty, slowed(t, factor), limits).ok) << seed;
  }
}

TEST(SmallestFactor, SpeedsUpWhatIsTooSlow) {
  const Trajectory slow = slowed(random_trajectory(3), 100);
  EXPECT_LT(smallest_factor(slow, {{Limit::speed, 5}, {Limit::acceleration, 3}}), 0.5);
}

TEST(SmallestFactor, IsOneWithoutLimitsOrMotion) {
  EXPECT_EQ(smallest_factor(random_trajectory(4), {}), 1);
  EXPECT_EQ(smallest_factor({{hermite({}, {}, 1)}}, {{Limit::speed, 5}, {Limit::acceleration, 3}}),
            1);
}

}  // namespace
}  // namespace traj
