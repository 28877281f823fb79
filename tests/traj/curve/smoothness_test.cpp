#include "traj/curve/smoothness.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(Snap, IsTheFiniteDifferenceOfTheJerk) {
  testing::Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Trajectory curve{{random.segment(), random.segment()}};
    const double t = random.number(0.05, 0.95) * duration(curve);
    const double h = 1e-5;
    if (std::abs(t - curve.segments[0].duration) < 2 * h) continue;
    const Vec3 slope = (evaluate(curve, t + h).jerk - evaluate(curve, t - h).jerk) / (2 * h);
    EXPECT_LT((snap(curve, t) - slope).norm(), 1e-5 * (1 + slope.norm())) << "case " << i;
  }
}

TEST(SmoothnessProperty, IsTheSumOfManyShortPieces) {
  testing::Random random(6);
  for (int i = 0; i < 20; ++i) {
    const Trajectory curve{{random.segment(), random.segment()}};
    constexpr int kPieces = 20000;
    double jerk = 0;
    double fourth = 0;
    const double step = duration(curve) / kPieces;
    for (int k = 0; k < kPieces; ++k) {
      const double t = (k + 0.5) * step;
      jerk += step * evaluate(curve, t).jerk.squaredNorm();
      fourth += step * snap(curve, t).squaredNorm();
    }
    const Smoothness whole = smoothness(curve);
    EXPECT_NEAR(whole.jerk / jerk, 1, 1e-3) << "case " << i;
    EXPECT_NEAR(whole.snap / fourth, 1, 1e-3) << "case " << i;
  }
}

TEST(Smoothness, OfAHopIsKnownByHand) {
  // From rest to rest over 1 m in 1 s: x = 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7.
  const Trajectory hop{{hermite({}, State{.position = {1, 0, 0}}, 1)}};
  EXPECT_NEAR(smoothness(hop).snap, 100800, 1e-6);
  EXPECT_NEAR(snap(hop, 0).x(), 840, 1e-9);
  EXPECT_NEAR(snap(hop, 1).x(), -840, 1e-9);
}

}  // namespace
}  // namespace traj
