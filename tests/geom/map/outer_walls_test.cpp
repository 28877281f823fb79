#include "geom/map/outer_walls.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

const Aabb kRoom{{0, 0, 0}, {10, 8, 3}};

TEST(OuterWalls, AreThinLongHighAndAtASide) {
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {0.2, 8, 3}},     // west
                                   {{9.8, 0, 0}, {10, 5, 3}},    // east
                                   {{0, 0.1, 0}, {10, 0.3, 2}},  // south
                                   {{0, 7.9, 0}, {10, 8, 3}},    // north
                                   {{0, 0, 2.9}, {10, 8, 3}},    // the ceiling
                                   {{0, 0, 0}, {10, 8, 0.1}},    // the floor
                                   {{5, 0, 0}, {5.2, 8, 3}},     // a wall inside
                                   {{0, 0, 0}, {0.2, 3, 3}},     // too short
                                   {{0, 0, 0}, {0.2, 8, 1}},     // too low
                                   {{0, 0, 0}, {4, 8, 3}}};      // too thick
  using enum RoomSide;
  EXPECT_EQ(outer_walls(boxes, kRoom),
            (std::vector{west, east, south, north, top, none, none, none, none, none}));
}

TEST(OuterWalls, HideTheRoomFromOutsideOnly) {
  const Aabb west{{0, 0, 0}, {0.2, 8, 3}};
  EXPECT_TRUE(hides_room(RoomSide::west, west, {-5, 4, 9}));
  EXPECT_FALSE(hides_room(RoomSide::west, west, {5, 4, 1}));
  const Aabb top{{0, 0, 2.9}, {10, 8, 3}};
  EXPECT_TRUE(hides_room(RoomSide::top, top, {5, 4, 9}));
  EXPECT_FALSE(hides_room(RoomSide::top, top, {5, 4, 1}));
  EXPECT_FALSE(hides_room(RoomSide::none, top, {5, 4, 9}));
}

}  // namespace
}  // namespace geom
