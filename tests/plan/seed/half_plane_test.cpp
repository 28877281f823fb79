#include "seed/half_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plan/scenes.h"
#include "support/exact_oracle.h"

namespace plan {
namespace {

const double kAny = std::numeric_limits<double>::infinity();
const geom::Aabb kStreet{{-10, -50, 0}, {110, 50, 100}};
const Vec3 kFrom(0, 0, 5);
const Vec3 kTo(100, 0, 5);
const HalfPlane kUpright(kFrom, kTo, {0, 0, 1});
const HalfPlane kLevel(kFrom, kTo, {0, 1, 0});

// In rationals, and inside the bounds.
bool exactly_free(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b) {
  for (const geom::Aabb& box : scene.map().boxes()) {
    if (oracle::segment_hits(a, b, box, scene.vehicle().half)) return false;
  }
  return scene.inside_bounds(a) && scene.inside_bounds(b);
}

TEST(HalfPlane, LeadsOverWhatStandsInTheWayByItsUpperChain) {
  const auto scene = scene_of({{{20, -5, 0}, {30, 5, 25}},
                               {{45, -5, 0}, {50, 5, 15}},  // below the chain
                               {{70, -5, 0}, {80, 5, 25}}},
                              kStreet);
  const geom::Polyline path = chain_in(scene, kUpright, kAny);
  ASSERT_EQ(path.size(), 4u);
  EXPECT_EQ(path.front(), kFrom);
  EXPECT_EQ(path.back(), kTo);
  EXPECT_NEAR((path[1] - Vec3(20, 0, 25)).norm(), 0, 0.002);
  EXPECT_NEAR((path[2] - Vec3(80, 0, 25)).norm(), 0, 0.002);
}

TEST(HalfPlane, LeadsRoundATowerWhereItIsLevel) {
  const auto scene = scene_of({{{40, -20, 0}, {60, 10, 99}}}, kStreet);
  const geom::Polyline path = chain_in(scene, kLevel, kAny);
  ASSERT_EQ(path.size(), 4u);
  for (const Vec3& p : path) EXPECT_EQ(p.z(), 5);
  EXPECT_NEAR(geom::length(path), 2 * std::hypot(40, 10) + 20, 0.01);
  EXPECT_TRUE(chain_in(scene, kUpright, 100).empty());  // out of the bounds, or too long
}

TEST(HalfPlane, HasNoChainUnderARoofOrBeyondALength) {
  const auto roof = scene_of({{{-5, -5, 10}, {60, 5, 20}}, {{50, -5, 0}, {55, 5, 15}}}, kStreet);
  EXPECT_TRUE(chain_in(roof, kUpright, kAny).empty());
  const auto wall = scene_of({{{50, -50, 0}, {55, 50, 40}}}, kStreet);
  const double length = geom::length(chain_in(wall, kUpright, kAny));
  EXPECT_GT(length, 120);
  EXPECT_FALSE(chain_in(wall, kUpright, length + 1e-9).empty());
  EXPECT_TRUE(chain_in(wall, kUpright, length).empty());
  EXPECT_TRUE(chain_in(wall, kLevel, kAny).empty());  // it reaches from side to side
}

// Of towers on the ground no path in the half-plane is shorter: each corner is below the chain.
TEST(HalfPlane, ChainsAreFreeByRationalsAndNoLongerThanTheyMustBe) {
  support::Random random(3);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<geom::Aabb> boxes;
    for (int k = random.below(12); k >= 0; --k) {
      const Vec3 low(random.stepped(0, 100, 1), random.uniform(-20, 15), 0);
      boxes.push_back({low, low + Vec3(random.stepped(1, 9, 1), random.uniform(0, 12),
                                       random.stepped(1, 60, 1))});
    }
    const auto scene = scene_of(boxes, kStreet, {0.5, 0.5, 0.5});
    if (!scene.free(kFrom) || !scene.free(kTo) || scene.free(kFrom, kTo)) continue;
    const geom::Polyline path = chain_in(scene, kUpright, kAny);
    ASSERT_FALSE(path.empty()) << "case " << i;
    ++found;
    for (std::size_t leg = 1; leg < path.size(); ++leg) {
      ASSERT_TRUE(exactly_free(scene, path[leg - 1], path[leg])) << "case " << i;
      if (leg < 2) continue;
      const double turn =
          (path[leg].z() - path[leg - 1].z()) / (path[leg].x() - path[leg - 1].x()) -
          (path[leg - 1].z() - path[leg - 2].z()) / (path[leg - 1].x() - path[leg - 2].x());
      ASSERT_LT(turn, 0) << "case " << i << ": it only bends down";
      const double off = scene.nearest(path[leg - 1], 1).value().distance;
      ASSERT_LT(off, 0.002) << "case " << i << ": every bend is at a box";
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace plan
