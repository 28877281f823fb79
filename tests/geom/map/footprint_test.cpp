#include "geom/map/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"

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

TEST(BoxesOf, HaveTheIdAndTheLabelOfTheirFeature) {
  std::vector<Footprint> city = {{{square(0, 10), {}}, 0, 5, 1}, {{square(20, 30), {}}, 0, 5, 2}};
  city[1].label = 7;
  const BoxTable table = boxes_of(city, 0.5, {});
  EXPECT_EQ(table.ids, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(table.label, (std::vector<std::uint32_t>{0, 7}));
}

// What no box holds lies outside the floor here and inside it there, in the same rows.
TEST(BoxesOf, TellTheCourtOfAFloorFromItsNotches) {
  const std::vector<Vec2> notched = {{0, 0},   {20, 0}, {20, 10}, {18, 10}, {18, 2}, {14, 2},
                                     {14, 10}, {4, 10}, {4, 2},   {2, 2},   {2, 10}, {0, 10}};
  for (const bool court : {false, true}) {
    Polygon roof{notched, {}};
    if (court) roof.holes = {{{7, 4}, {11, 4}, {11, 8}, {7, 8}}};
    const std::vector<Footprint> house = {{roof, 0, 5, 1, false}, {{notched, {}}, 0, 0, 1, true}};
    const BoxTable table = boxes_of(house, 0.2, {});
    EXPECT_EQ(any_holds(table, {9, 6, 0}), true);
    EXPECT_EQ(any_holds(table, {9, 6, 1}), !court);
    EXPECT_FALSE(any_holds(table, {3, 6, 0}));
    EXPECT_FALSE(any_holds(table, {16, 6, 0}));
    const auto flat = [](const Aabb& box) { return box.max.z() == 0; };
    EXPECT_EQ(std::any_of(table.boxes.begin(), table.boxes.end(), flat), court);
  }
}

// The sides may lie beside those of the polygon, further out or further in.
TEST(BoxesOf, HoldWhatBulgesAndReachNoFurtherThanFromWhatIsHollow) {
  const double slack = 0.5;
  for (const double bulge : {0.001, 0.02, 0.15}) {
    for (const double lean : {0.0, 0.1, 1.0}) {
      const auto sheared = [&](double by) -> std::vector<Vec2> {
        return {{-by, -by}, {8 + by, lean - by}, {8 + by, lean + 5 + by}, {-by, 5 + by}};
      };
      Footprint f{{sheared(0), {}}, 0, 5, 1};
      f.bulge = bulge;
      const BoxTable table = boxes_of({f}, slack, {});
      std::vector<Rectangle> rectangles;
      for (const Aabb& box : table.boxes) {
        rectangles.push_back({box.min.head<2>(), box.max.head<2>()});
      }
      EXPECT_TRUE(oracle::exactly_covered({sheared(0.7 * bulge), {}}, rectangles));
      for (const Rectangle& r : rectangles) {
        EXPECT_LE(oracle::furthest_outside({sheared(-0.7 * bulge), {}}, r, 5e-3), slack + 5e-3);
      }
    }
  }
}

TEST(BoxesOf, RefusesABulgeBeyondTheSlack) {
  Footprint f{{{{0, 0}, {40, 3}, {40, 12}, {0, 9}}, {}}, 0, 5, 1};
  f.bulge = 0.4;
  EXPECT_THROW(boxes_of({f}, 0.5, {}), InputError);
}

}  // namespace
}  // namespace geom
