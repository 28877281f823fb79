#include "geom/map/buildings.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

const std::vector<Aabb> kStrips = {{{0, 0, 0}, {1, 5, 9}},   {{1, 0, 0}, {2, 6, 9}},
                                   {{2, 0, 0}, {3, 5, 9}},   {{20, 0, 0}, {25, 5, 9}},
                                   {{3, 0, 0}, {6, 5, 8.5}}, {{0, 0, 20}, {1, 5, 29}}};

TEST(Buildings, TouchAndShareTheHeightOfTheirTops) {
  const Buildings found = buildings_of({.boxes = kStrips});
  EXPECT_EQ(found.of, (std::vector<std::uint32_t>{0, 0, 0, 1, 2, 3}));
  EXPECT_EQ(found.count, 4u);
}

TEST(Buildings, ShareAnIdWhereSuchBoxesTouch) {
  const std::vector<std::uint64_t> ids = {7, 7, 8, 7, 8, 7};
  const std::vector<std::uint32_t> labels = {1, 1, 1, 1, 1, 1};
  const Buildings found = buildings_of({.boxes = kStrips, .ids = ids, .labels = labels});
  EXPECT_EQ(found.of, (std::vector<std::uint32_t>{0, 0, 1, 2, 1, 3}));
}

TEST(Buildings, ShareALabelWhereNoIdsAreShared) {
  const std::vector<std::uint64_t> ids = {1, 2, 3, 4, 5, 6};
  const std::vector<std::uint32_t> labels = {1, 1, 0, 1, 0, 1};
  const Buildings found = buildings_of({.boxes = kStrips, .ids = ids, .labels = labels});
  EXPECT_EQ(found.of, (std::vector<std::uint32_t>{0, 0, 1, 2, 3, 4})) << "0 is no label";
}

TEST(Buildings, KnowWhichWallsStandInside) {
  const Buildings found = buildings_of({.boxes = kStrips});
  EXPECT_EQ(found.covered[0], 2) << "its east wall, behind a longer one";
  EXPECT_EQ(found.covered[1], 0) << "longer than both neighbours";
  EXPECT_EQ(found.covered[2], 1);
  EXPECT_EQ(found.covered[3], 0);
}

TEST(Buildings, HaveATypicalSize) {
  const std::vector<Aabb> three = {
      {{0, 0, 0}, {3, 4, 1}}, {{10, 0, 0}, {16, 8, 1}}, {{90, 0, 0}, {91, 0, 1}}};
  EXPECT_EQ(buildings_of({.boxes = three}).typical, 5);
  EXPECT_EQ(buildings_of({}).typical, 1);
  EXPECT_EQ(buildings_of({}).count, 0u);
}

}  // namespace
}  // namespace geom
