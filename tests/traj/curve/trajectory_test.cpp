#include "traj/curve/trajectory.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(Hermite, HasTheGivenStatesAtItsEnds) {
  testing::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const State a = random.state(10);
    const State b = random.state(10);
    const double t = random.number(0.1, 5);
    const Segment s = hermite(a, b, t);
    for (const auto& [want, got] : {std::pair{a, evaluate(s, 0)}, std::pair{b, evaluate(s, t)}}) {
      EXPECT_EQ(want.position, got.position) << "case " << i;
      EXPECT_LT((want.velocity - got.velocity).norm(), 1e-10) << "case " << i;
      EXPECT_LT((want.acceleration - got.acceleration).norm(), 1e-8) << "case " << i;
      EXPECT_LT((want.jerk - got.jerk).norm(), 1e-6) << "case " << i;
    }
  }
}

TEST(Hermite, IsTheSeventhPowerWhereItsEndsAre) {
  const Segment s = hermite(
      {}, {Vec3::Constant(1), Vec3::Constant(7), Vec3::Constant(42), Vec3::Constant(210)}, 1);
  for (int i = 0; i < kDegree; ++i) EXPECT_LT(s.point[static_cast<std::size_t>(i)].norm(), 1e-13);
  EXPECT_NEAR(evaluate(s, 0.5).position.x(), 1.0 / 128, 1e-14);
}

TEST(Evaluate, DerivativesMatchFiniteDifferences) {
  testing::Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Segment s = random.segment();
    const double t = s.duration * random.number(0.1, 0.9);
    const double h = 1e-5;
    const State before = evaluate(s, t - h);
    const State here = evaluate(s, t);
    const State after = evaluate(s, t + h);
    const auto close = [&](const Vec3& a, const Vec3& b) {
      EXPECT_LT((a - b).norm(), 1e-5 * (1 + b.norm())) << "case " << i;
    };
    close((after.position - before.position) / (2 * h), here.velocity);
    close((after.velocity - before.velocity) / (2 * h), here.acceleration);
    close((after.acceleration - before.acceleration) / (2 * h), here.jerk);
  }
}

TEST(Evaluate, AtAJointIsTheLaterSegment) {
  Trajectory two;
  two.segments.push_back(hermite({}, {Vec3(1, 0, 0)}, 2));
  two.segments.push_back(hermite({Vec3(5, 0, 0)}, {Vec3(6, 0, 0)}, 3));
  EXPECT_EQ(evaluate(two, 2).position, Vec3(5, 0, 0));
  EXPECT_EQ(evaluate(two, -1).position, Vec3(0, 0, 0));
  EXPECT_EQ(evaluate(two, 9).position, Vec3(6, 0, 0));
  EXPECT_EQ(duration(two), 5);
}

}  // namespace
}  // namespace traj
