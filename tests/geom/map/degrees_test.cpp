#include "geom/map/degrees.h"

#include <gtest/gtest.h>

#include <vector>

namespace geom {
namespace {

Frame city() {
  Frame frame;
  frame.origin = GeodeticOrigin{37.7925, -122.3974, 0};
  return frame;
}

bool looks(std::vector<Vec3> points) { return look_like_degrees(city(), points); }

TEST(LookLikeDegrees, InEitherOrderNearTheOrigin) {
  EXPECT_TRUE(looks({{37.793, -122.397, 5}, {37.794, -122.396, 5}}));
  EXPECT_TRUE(looks({{-122.397, 37.793, 5}}));
  EXPECT_FALSE(looks({{37.793, -122.397, 5}, {-122.396, 37.794, 5}}));
}

TEST(LookLikeDegrees, NotWhereOnePointIsMetres) {
  EXPECT_FALSE(looks({{37.793, -122.397, 5}, {12.5, 30.5, 5}}));
  EXPECT_FALSE(looks({{37.793, -122, 5}}));  // a whole number
  EXPECT_FALSE(looks({{38.4, -122.397, 5}}));
  EXPECT_FALSE(looks({}));
}

TEST(LookLikeDegrees, NotOnAMapWithoutAnOrigin) {
  EXPECT_FALSE(look_like_degrees({}, std::vector<Vec3>{{37.793, -122.397, 5}}));
}

TEST(MayBeDegrees, WhereAnOutlineIsSmallAndNoNumberIsWhole) {
  const std::vector<Vec3> small = {{24.5, 60.25, 0}, {24.75, 60.5, 0}};
  const auto found = may_be_degrees(small);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->low, Vec3(24.5, 60.25, 0));
  EXPECT_EQ(found->high, Vec3(24.75, 60.5, 0));
  EXPECT_FALSE(may_be_degrees(std::vector<Vec3>{{24.5, 60.25, 0}, {27.5, 60.5, 0}}));
  EXPECT_FALSE(may_be_degrees(std::vector<Vec3>{{24.5, 60.25, 0}, {25, 60.5, 0}}));
}

}  // namespace
}  // namespace geom
