#include "traj/proof/clearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::CollisionScene;
using testing::one_box;
using testing::rest;

TEST(ClearanceProfile, HasTheLeastOfEachPart) {
  const CollisionScene scene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0);
  const Trajectory line = {{hermite(rest({-10, 4, 0}), rest({0, 4, 0}), 4),
                            hermite(rest({0, 4, 0}), rest({10, 4, 0}), 4)}};
  const auto profile = clearance_profile(scene, line, 0.3);
  ASSERT_EQ(profile.size(), 28u);
  EXPECT_EQ(profile.front().begin, 0);
  EXPECT_EQ(profile.back().end, 8);
  double least = 1e9;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const auto& span = profile[i];
    if (i) {
      EXPECT_EQ(span.begin, profile[i - 1].end);
    }
    EXPECT_LE(span.end - span.begin, 0.3);
    double sampled = 1e9;
    for (int k = 0; k <= 100; ++k) {
      const double t = span.begin + (span.end - span.begin) * k / 100;
      sampled = std::min(sampled, scene.nearest(evaluate(line, t).position, 100)->distance);
    }
    EXPECT_LE(span.clearance, sampled + 1e-3);
    EXPECT_NEAR(span.clearance, sampled, 0.02);
    least = std::min(least, span.clearance);
  }
  EXPECT_NEAR(least, 2.5, 1e-3);
}

TEST(ClearanceProfile, RunsAlongAPath) {
  const CollisionScene scene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0);
  const std::vector<Vec3> path = {{-10, 4, 0}, {0, 4, 0}, {0, 4, 0}, {0, 8, 0}};
  const auto profile = clearance_profile(scene, path, 5);
  ASSERT_EQ(profile.size(), 4u);
  EXPECT_NEAR(profile[0].clearance, std::hypot(3.5, 2.5), 1e-3);
  EXPECT_NEAR(profile[1].clearance, 2.5, 1e-3);
  EXPECT_EQ(profile[3].begin, 10);
  EXPECT_EQ(profile[3].end, 14);
  EXPECT_NEAR(profile[3].clearance, 2.5, 1e-3);
  const std::vector<double> times = {1, 2, 3, 7};
  const auto timed = clearance_profile(scene, path, times);
  ASSERT_EQ(timed.size(), 3u);
  EXPECT_NEAR(timed[0].clearance, 2.5, 1e-3);
  EXPECT_NEAR(timed[1].clearance, 2.5, 1e-3);
  EXPECT_EQ(timed[2].begin, 3);
  EXPECT_EQ(timed[2].end, 7);
}

}  // namespace
}  // namespace traj
