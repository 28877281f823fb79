#include "path/shortcut.h"

#include <gtest/gtest.h>

#include "plan/lattice/build_lattice.h"
#include "plan/planner/plan.h"
#include "plan/scenes.h"
#include "support/random_city.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {20, 20, 20}};

bool all_free(const geom::CollisionScene& scene, const geom::Polyline& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!scene.free(path[i - 1], path[i])) return false;
  }
  return true;
}

TEST(Shortcut, IsTheStraightLineWhereThatIsFree) {
  const auto scene = scene_of({}, kCube);
  const geom::Polyline path = {{1, 1, 1}, {10, 1, 1}, {10, 10, 1}, {10, 10, 10}};
  EXPECT_EQ(shortcut(scene, path), (geom::Polyline{{1, 1, 1}, {10, 10, 10}}));
}

TEST(Shortcut, LeavesPathsOfOneSegmentAlone) {
  const auto scene = scene_of({}, kCube);
  const geom::Polyline path = {{1, 1, 1}, {2, 2, 2}};
  EXPECT_EQ(shortcut(scene, path), path);
  EXPECT_EQ(shortcut(scene, {{1, 1, 1}}), (geom::Polyline{{1, 1, 1}}));
}

TEST(Shortcut, CutsCornersBetweenTheOriginalPoints) {
  const auto scene = scene_of({{{8, -1, -1}, {12, 10, 21}}}, kCube);
  const geom::Polyline path = {{1, 1, 1}, {1, 18, 1}, {19, 18, 1}, {19, 1, 1}};
  const geom::Polyline shorter = shortcut(scene, path);
  EXPECT_TRUE(all_free(scene, shorter));
  const double taut = 2 * std::hypot(7, 9) + 4;  // round both corners of the box
  EXPECT_LT(geom::length(shorter), 1.03 * taut);
  EXPECT_GT(geom::length(shorter), taut);
}

TEST(Shortcut, KeepsTheEndsIsFreeAndNeverLonger) {
  int bent = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const auto scene = random_scene(seed, 120, 20, Vec3::Constant(0.2));
    const Lattice lattice = build_lattice(scene, {1, Connectivity::six, {0.5, 0.5, 0.5}});
    Planner planner(scene, &lattice);
    const PlanResult raw = planner.plan({0.5, 0.5, 0.5}, {19.3, 19.3, 15}, {.raw = true});
    if (raw.status != PathStatus::found) continue;
    bent += raw.path.size() > 2;
    const geom::Polyline shorter = shortcut(scene, raw.path);
    EXPECT_EQ(shorter.front(), raw.path.front());
    EXPECT_EQ(shorter.back(), raw.path.back());
    EXPECT_TRUE(all_free(scene, shorter));
    EXPECT_LE(geom::length(shorter), geom::length(raw.path) + 1e-9);
    EXPECT_EQ(shorter, shortcut(scene, raw.path));
  }
  EXPECT_GT(bent, 5);
}

TEST(ResampleFree, CutsFreeSegmentsAndKeepsThePoints) {
  const auto scene = scene_of({}, kCube);
  const geom::Polyline path = {{1, 1, 1}, {4, 1, 1}, {4, 2, 1}};
  EXPECT_EQ(resample_free(scene, path, 1).size(), 5u);
}

// The parts of a steep segment are rounded; along the edge of a box some of them touch it.
TEST(ResampleFree, LeavesNoPartInTouch) {
  const auto scene = random_scene(2, 200, 20, Vec3::Zero());
  support::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Vec3 ends[2];
    for (Vec3& p : ends) p = {random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 20)};
    if (!scene.free(ends[0], ends[1])) continue;
    const geom::Polyline parts = resample_free(scene, {ends[0], ends[1]}, 0.7);
    EXPECT_TRUE(all_free(scene, parts));
    EXPECT_EQ(parts.front(), ends[0]);
    EXPECT_EQ(parts.back(), ends[1]);
  }
}

}  // namespace
}  // namespace plan
