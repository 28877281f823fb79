#include "geom/cloud/ground_filter.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using geom::CloudPoint;

// A plane of 40 x 40 m with a block on it; `cls` of the plane.
std::vector<CloudPoint> scan(std::uint8_t cls) {
  std::vector<CloudPoint> out;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) {
      const bool block = x > 15 && x < 25 && y > 15 && y < 25;
      out.push_back({{x + 0.5, y + 0.5, block ? 6.0 : 0.0}, block ? std::uint8_t{1} : cls});
    }
  }
  return out;
}

geom::GroundFilter filter_of(const std::vector<CloudPoint>& points, const std::string& by) {
  geom::GroundFilter filter({}, by);
  for (const CloudPoint& p : points) filter.add(p);
  filter.finish();
  return filter;
}

TEST(GroundFilter, IsOfTheClassWhereAPointHasIt) {
  const auto points = scan(2);
  const auto filter = filter_of(points, "auto");
  EXPECT_EQ(filter.by(), "class");
  EXPECT_TRUE(filter.is_ground({{20, 20, 6}, 2}));  // the file says so
  EXPECT_FALSE(filter.is_ground({{1, 1, 0}, 1}));
}

TEST(GroundFilter, IsOfTheShapeWhereNoPointHasTheClass) {
  for (const char* by : {"auto", "shape"}) {
    const auto filter = filter_of(scan(1), by);
    EXPECT_EQ(filter.by(), "shape");
    EXPECT_TRUE(filter.is_ground({{9, 9, 0}, 1}));
    EXPECT_FALSE(filter.is_ground({{20, 20, 6}, 1}));
  }
  EXPECT_EQ(filter_of(scan(2), "shape").by(), "shape");
}

TEST(GroundFilter, NoiseIsNeitherLookedAtNorGround) {
  auto points = scan(1);
  for (int i = 0; i < 40; ++i) points.push_back({{i + 0.5, 20.5, -30}, 7});
  const auto filter = filter_of(points, "auto");
  EXPECT_TRUE(filter.is_ground({{9, 9, 0}, 1}));
  EXPECT_FALSE(filter.is_ground({{9, 9, 0}, 7}));
  EXPECT_FALSE(filter.is_ground({{9, 9, 0}, 18}));
}

}  // namespace
