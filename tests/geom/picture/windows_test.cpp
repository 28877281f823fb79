// Which boxes wear windows.

#include "picture/windows.h"

#include <gtest/gtest.h>

#include "support/small_map.h"

namespace {

using geom::Aabb;

TEST(NamesNoBuilding, GoesByWords) {
  for (const char* label : {"tree", "Trees", "natural=tree", "SolitaryVegetationObject",
                            "lamp post", "255 0 0", "keep-out", "wall_3"}) {
    EXPECT_TRUE(geom::picture::names_no_building(label)) << label;
  }
  for (const char* label : {"", "building", "Main Street 5", "BuildingPart", "Woodward tower"}) {
    EXPECT_FALSE(geom::picture::names_no_building(label)) << label;
  }
}

TEST(Windows, AreOnBuildingsAndTheirTowersNotOnTreesAndPoles) {
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {20, 20, 10}},       // a building,
                                   {{5, 5, 10}, {15, 15, 40}},      // its tower,
                                   {{40, 40, 0}, {40.5, 40.5, 4}},  // a trunk
                                   {{37, 37, 4}, {43, 43, 12}},     // and its crown,
                                   {{60, 60, 0}, {70, 70, 2}},      // something low,
                                   {{80, 80, 20}, {90, 90, 30}}};   // and what hangs on nothing
  const geom::BoxMap map = support::map_of({{0, 0, 0}, {100, 100, 50}}, boxes);
  const std::vector<bool> windows = geom::picture::windows_of(map);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const std::uint64_t id = map.ids()[i];
    EXPECT_EQ(windows[i], id == 1 || id == 2 || id == 6) << "box " << id;
  }
}

}  // namespace
