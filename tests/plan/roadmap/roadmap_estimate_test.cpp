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

}  // namespace
}  // namespace plan
