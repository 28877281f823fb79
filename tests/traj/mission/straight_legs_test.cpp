#include "traj/mission/straight_legs.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

using testing::Random;
using testing::scene_of;

double distance_to(const geom::Polyline& path, const Vec3& p) {
  double best = 1e300;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 leg = path[i] - path[i - 1];
    const double s = std::clamp((p - path[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (p - path[i - 1] - s * leg).norm());
  }
  return best;
}

TEST(StraightLegs, StayWithinTheToleranceOfTheCurveAndStartAndEndOnIt) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    Trajectory t{{random.segment()}};
    const State end = evaluate(t.segments[0], t.segments[0].duration);
    t.segments.push_back(hermite(end, random.state(10), 2));
    std::size_t last = 0;
    for (const double tolerance : {1.0, 0.1, 0.01}) {
      const geom::Polyline legs = straight_legs(t, tolerance);
      EXPECT_EQ(legs.front(), t.segments.front().point.front());
      EXPECT_EQ(legs.back(), t.segments.back().point.back());
      EXPECT_GE(legs.size(), last);
      last = legs.size();
      for (double s = 0; s < duration(t); s += 0.01) {
        EXPECT_LE(distance_to(legs, evaluate(t, s).position), tolerance) << "case " << i;
      }
    }
  }
}

TEST(StraightLegs, OfAStraightTrajectoryAreOne) {
  const Vec3 a(0, 0, 1);
  const Vec3 b(3, 4, 5);
  EXPECT_EQ(straight_legs({{{2, {a, a, a, a, b, b, b, b}, {}}}}, 1e-3), (geom::Polyline{a, b}));
}

TEST(PushedOff, MovesInnerPointsAwayFromEdgesAndBoundsAndNoEnd) {
  const auto scene = scene_of({{{0, 0, 0}, {10, 10, 10}}});
  const auto moved = pushed_off(
      scene,
      {{-0.001, -0.001, 5}, {-0.001, -0.001, 5}, {5, 10.5, 5}, {50, 50, 100}, {-0.001, -0.001, 5}},
      0.1);
  EXPECT_EQ(moved.front(), Vec3(-0.001, -0.001, 5));
  EXPECT_EQ(moved.back(), Vec3(-0.001, -0.001, 5));
  EXPECT_LT((moved[1] - Vec3(-0.1, -0.1, 5)).norm(), 1e-8);
  EXPECT_EQ(moved[2], Vec3(5, 10.5, 5));
  EXPECT_EQ(moved[3], Vec3(50, 50, 99.9));
}

}  // namespace
}  // namespace traj
