#include "curve/continuity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "traj/scenes.h"

namespace traj {
namespace {

double choose(int n, int k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

// x = t^power on [0, seconds].
Segment monomial(int power, double seconds) {
  Segment s;
  s.duration = seconds;
  s.point.fill(Vec3::Zero());
  for (int i = power; i < kPoints; ++i) {
    s.point[static_cast<std::size_t>(i)].x() =
        choose(i, power) / choose(kDegree, power) * std::pow(seconds, power);
  }
  return s;
}

// Where a curve that rests goes on as t^k, the k-th derivative alone jumps, by k!.
TEST(LargestJumps, AreOfTheDerivativeThatJumps) {
  Segment rest;
  rest.duration = 3;
  rest.point.fill(Vec3::Zero());
  for (int k = 0; k < 7; ++k) {
    const auto jumps = largest_jumps({{rest, monomial(k, 2)}});
    for (int d = 0; d < 7; ++d) {
      EXPECT_NEAR(jumps[static_cast<std::size_t>(d)], d == k ? std::tgamma(k + 1) : 0, 1e-9)
          << "t^" << k << ", derivative " << d;
    }
  }
}

TEST(LargestJumps, AreTheLargestOfAllJointsByTheirNorm) {
  testing::Random random(1);
  const State a = random.state(5);
  const State b = random.state(5);
  State c = b;
  c.position += Vec3(3, 4, 0);
  State d = a;
  d.position += Vec3(0, 0, 2);
  d.velocity += Vec3(0, 6, 8);
  const auto jumps = largest_jumps({{hermite(a, b, 2), hermite(c, a, 1), hermite(d, b, 3)}});
  EXPECT_NEAR(jumps[0], 5, 1e-12);
  EXPECT_NEAR(jumps[1], 10, 1e-11);
  EXPECT_NEAR(jumps[2], 0, 1e-10);
  EXPECT_NEAR(jumps[3], 0, 1e-9);
}

TEST(LargestJumps, AreNoneOfOneSegmentAndPassNoNanBy) {
  testing::Random random(2);
  for (const double jump : largest_jumps({{random.segment()}})) EXPECT_EQ(jump, 0);
  Trajectory t{{random.segment(), random.segment()}};
  t.segments[1].point[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(largest_jumps(t)[0]));
}

}  // namespace
}  // namespace traj
