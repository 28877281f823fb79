#include "traj/home/landing_site.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/home/home_case.h"

namespace traj {
namespace {

using support::says;
using testing::drawn_at;
using testing::small_vehicle;
using testing::town;

const geom::Aabb kBlock{{40, 40, 0}, {60, 60, 20}};
const geom::Aabb kRoof{{10, 10, 8}, {30, 30, 9}};  // on posts

std::string refused(const DrawnSite& site) {
  const auto scene = small_vehicle(town({kBlock, kRoof}));
  return support::refusal_of([&] { landing_site(scene, site, "sites.geojson"); });
}

TEST(LandingSite, IsOnTheGroundOrOnTheRoofBelow) {
  const auto scene = small_vehicle(town({kBlock}));
  const LandingSite ground = landing_site(scene, drawn_at(20, 20), "s");
  EXPECT_EQ(ground.ground, Vec3(20, 20, 0));
  EXPECT_EQ(ground.above, Vec3(20, 20, kApproachHeight + scene.half().z()));
  const LandingSite roof = landing_site(scene, drawn_at(50, 50), "s");
  EXPECT_EQ(roof.ground, Vec3(50, 50, 20));
  EXPECT_EQ(landing_site(scene, drawn_at(50, 50, 20.3), "s").ground.z(), 20) << "the map's height";
}

TEST(LandingSite, IsRefusedWithItsFeatureAndTheReason) {
  EXPECT_EQ(refused(drawn_at(120, 20)),
            "sites.geojson: feature 1 (\"pad\"): the site is outside of the map's bounds");
  EXPECT_TRUE(says(refused(drawn_at(0.2, 20)), "outside")) << "a part of it";
  EXPECT_TRUE(says(refused(drawn_at(50, 50, 0)), "inside a building"));
  EXPECT_TRUE(says(refused(drawn_at(59.8, 50)), "roof edge"));
  EXPECT_TRUE(says(refused(drawn_at(59.8, 50, 20)), "roof edge"));
  EXPECT_TRUE(says(refused(drawn_at(20, 80, 7)), "said to be at 7 m"));
  EXPECT_TRUE(says(refused(drawn_at(20, 80, -9)), "outside"));
  EXPECT_TRUE(says(refused(drawn_at(39.7, 50, 0)), "the column above the site is not clear"))
      << "a wall beside it";
}

TEST(LandingSite, MayBeBelowWhatIsHigherThanItsApproach) {
  const auto scene = small_vehicle(town({kRoof}));
  EXPECT_EQ(landing_site(scene, drawn_at(20, 20, 0), "s").ground.z(), 0);
  EXPECT_EQ(landing_site(scene, drawn_at(20, 20), "s").ground.z(), 9) << "the highest top";
  const auto low = small_vehicle(town({{{10, 10, 4}, {30, 30, 5}}}));
  EXPECT_NE(support::refusal_of([&] { landing_site(low, drawn_at(20, 20, 0), "s"); }), "");
}

TEST(LandingSite, IsThePlaceOfAPolygonFurthestFromItsEdgesThatIsFree) {
  const auto empty = small_vehicle(town({}));
  DrawnSite yard = drawn_at(0, 0);
  yard.outline.outer = {{10, 10}, {43, 10}, {43, 43}, {10, 43}, {10, 10}};
  EXPECT_EQ(landing_site(empty, yard, "s").ground, Vec3(26.5, 26.5, 0));
  yard.ground = 0;
  const auto tree = small_vehicle(town({{{25, 25, 0}, {28, 28, 9}}}));
  const LandingSite beside = landing_site(tree, yard, "s");
  EXPECT_EQ(beside.ground.z(), 0);
  EXPECT_TRUE(tree.free(beside.above));
  yard.outline.holes = {{{11, 11}, {42, 11}, {42, 42}, {11, 42}}};
  EXPECT_TRUE(says(support::refusal_of([&] { landing_site(empty, yard, "s"); }), "does not fit"));
}

TEST(LandingFault, WantsAStraightWayDownToWholeGround) {
  const auto scene = small_vehicle(town({kBlock}));
  EXPECT_EQ(landing_fault(scene, {20, 20, 5}, {20, 20, 0}), "");
  EXPECT_NE(landing_fault(scene, {20, 21, 5}, {20, 20, 0}), "");
  EXPECT_NE(landing_fault(scene, {20, 20, 5}, {20, 20, 1}), "") << "it would hang in the air";
  EXPECT_NE(landing_fault(scene, {20, 20, 0}, {20, 20, 0}), "");
  EXPECT_NE(landing_fault(scene, {50, 50, 30}, {50, 50, 0}), "");
}

}  // namespace
}  // namespace traj
