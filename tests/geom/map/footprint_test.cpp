#include "geom/map/footprint.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

std::vector<Vec2> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

bool any_holds(const BoxTable& table, const Vec3& p) {
  for (const Aabb& box : table.boxes) {
    if (contains(box, p)) return true;
  }
  return false;
}

TEST(BoxesOf, LeaveOutAFloorThatTheRoofHolds) {
  const std::vector<Footprint> house = {{{square(0, 10), {}}, 0, 5, 1, false},
                                        {{square(0, 10), {}}, 0, 0, 1, true}};
  EXPECT_EQ(boxes_of(house, 0.5, {}).boxes.size(), 1u);
}

TEST(BoxesOf, KeepAFloorUnderAnOpenCourt) {
  const std::vector<Footprint> house = {{{square(0, 10), {square(3, 7)}}, 0, 5, 1, false},
                                        {{square(0, 10), {}}, 0, 0, 1, true}};
  const BoxTable table = boxes_of(house, 0.2, {});
  EXPECT_TRUE(any_holds(table, {5, 5, 0}));
  EXPECT_FALSE(any_holds(table, {5, 5, 1}));
}

}  // namespace
}  // namespace geom
