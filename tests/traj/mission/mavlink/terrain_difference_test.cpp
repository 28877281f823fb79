#include "mission/mavlink/terrain_difference.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

constexpr double kTower = 60;  // m

// Flat ground with a tower over a cell of 20 m, whose western edge is so far east of home.
geom::GroundModel tower_at(double east) {
  geom::GroundGridSpec spec;
  spec.corner = {-1000, -1010};
  spec.cell = 20;
  spec.columns = spec.rows = 100;
  std::vector<double> low(10000, 0.0);
  std::vector<double> high(10000, 0.0);
  high[50 * 100 + static_cast<std::size_t>((east + 1000) / 20)] = kTower;
  return {spec, low, high};
}

TerrainRange over(const geom::GroundModel& model, double east) {
  const TerrainDifference difference({&model, geom::Axes::enu, 0}, {0, 0}, 47, 100, 0, "m");
  return difference.over({{east, 0}, {east, 0}});
}

// At 47 degrees a post's height may be of a place that is 0.474 of a spacing away from the post.
TEST(TerrainDifference, CountsPlacesWhoseHeightsThePostsAroundHomeMayHave) {
  EXPECT_LT(over(tower_at(140), -500).low, -kTower);
  EXPECT_GT(over(tower_at(160), -500).low, -5);
}

// A post 213 m east of home may have the height of a place at 260 m. Beside it stands one at 113 m.
// So the terrain at 147 m may be higher by 0.34 of the tower.
TEST(TerrainDifference, NearHomeGrowsAsFastAsPostsThatHaveHeightsOfFurtherPlaces) {
  const geom::GroundModel model = tower_at(260);
  EXPECT_GT(over(model, 147).high, 0.34 * kTower);
  EXPECT_GT(over(model, 101).high, 0.01 * kTower);
  EXPECT_GT(over(tower_at(240), 99).high, 0.06 * kTower) << "a post at 193 m, beside one at 93 m";
  EXPECT_LT(over(model, 50).high, 5);
  EXPECT_LT(over(tower_at(-240), 10).high, 0.15 * kTower) << "the slope from home on";
}

}  // namespace
}  // namespace traj
