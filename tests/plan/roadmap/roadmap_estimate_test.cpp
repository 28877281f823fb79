#include "plan/roadmap/roadmap_estimate.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

TEST(RoadmapEstimate, IsNearWhatIsBuilt) {
  const auto scene = random_scene(5, 9000, 1500, {0.5, 0.5, 0.25});
  for (const double reach : {40.0, 120.0}) {
    const RoadmapSpec spec{10, reach, {}};
    const Roadmap built = build_roadmap(scene, spec, {2, {}});
    const RoadmapEstimate estimate = estimate_roadmap(scene, spec, [] { return 0.0; });
    const auto bends = static_cast<double>(built.bends());
    const auto edges = static_cast<double>(built.edges());
    EXPECT_NEAR(estimate.bends / bends, 1, 0.1) << reach;
    EXPECT_NEAR(estimate.edges / edges, 1, 0.2) << reach;
    EXPECT_NEAR(estimate.bytes / (34 * bends + 8 * edges), 1, 0.2) << reach;
  }
}

// A clock that stands still but while tiles are built, which the caller need not know.
TEST(RoadmapEstimate, TimesGoByTheClockThatIsGiven) {
  const auto scene = random_scene(5, 300, 300, {0.5, 0.5, 0.25});
  double now = 0;
  const auto clock = [&] { return now += 1; };
  EXPECT_GT(estimate_roadmap(scene, {10, 40, {}}, clock).seconds, 0);
  EXPECT_EQ(estimate_roadmap(scene, {10, 40, {}}, [] { return 7.0; }).seconds, 0);
}

TEST(RoadmapEstimate, OfNothingIsNothing) {
  const auto scene = scene_of({{{5, 5, 5}, {9, 9, 9}}}, {{0, 0, 0}, {60, 60, 60}});
  const RoadmapSpec spec{10, 40, geom::Aabb{{30, 30, 30}, {40, 40, 40}}};
  EXPECT_EQ(estimate_roadmap(scene, spec, [] { return 0.0; }).bends, 0);
}

TEST(RoughEstimate, GrowsWithTheBoxesAndTheReachAndFallsWithTheArea) {
  const geom::Aabb area{{0, 0, 0}, {5000, 5000, 100}};
  const RoadmapEstimate one = rough_estimate(1000, 500, area);
  EXPECT_EQ(one.bends, 9000);
  EXPECT_EQ(one.edges, 0.5 * 9000 * 500);
  EXPECT_EQ(one.bytes, 34 * one.bends + 8 * one.edges);
  EXPECT_GT(rough_estimate(2000, 500, area).seconds, 3.9 * one.seconds);
  EXPECT_GT(rough_estimate(1000, 1000, area).seconds, 3.9 * one.seconds);
  EXPECT_GT(rough_estimate(1000, 500, {{0, 0, 0}, {2500, 5000, 100}}).seconds, 1.9 * one.seconds);
}

TEST(RoadmapEstimate, IsSaidInSecondsAndFromTwoMinutesOnInMinutes) {
  EXPECT_EQ(in_words({1.25e6, 3e7, 2.5e8, 119.5}),
            "about 1.2 million bends, 30 million edges and 0.2 GB, and take about 120 seconds of a "
            "core");
  EXPECT_EQ(in_words({1e6, 3e7, 1e9, 121}),
            "about 1.0 million bends, 30 million edges and 1.0 GB, and take about 3 minutes of a "
            "core");
}

}  // namespace
}  // namespace plan
