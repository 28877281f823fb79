#include "geom/shape/nearest_share.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/segment_distance.h"

namespace geom {
namespace {

const Aabb kCube{{-1, -1, -1}, {1, 1, 1}};

TEST(NearestShare, IsWhereTheSegmentPassesTheBox) {
  EXPECT_DOUBLE_EQ(nearest_share({-3, 4, 3}, {3, -4, 3}, kCube), 0.375);  // the first above it
  EXPECT_DOUBLE_EQ(nearest_share({-5, 3, 0}, {5, 3, 0}, kCube), 0.4);
  EXPECT_DOUBLE_EQ(nearest_share({1, 3, 0}, {4, 2, 0}, kCube), 0.2);
}

TEST(NearestShare, IsAnEndWhereTheSegmentComesOrGoes) {
  EXPECT_EQ(nearest_share({2, 0, 0}, {9, 0, 0}, kCube), 0);
  EXPECT_EQ(nearest_share({9, 0, 0}, {2, 0, 0}, kCube), 1);
  EXPECT_EQ(nearest_share({5, 5, 5}, {5, 5, 5}, kCube), 0);  // no way at all
  EXPECT_EQ(nearest_share({0, 0, 0}, {9, 0, 0}, kCube), 0);  // begins inside
}

TEST(NearestShare, GivesTheDistanceOfAnyOtherSearch) {
  support::Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto point = [&](double half) {
      return Vec3(random.stepped(-half, half, 1), random.stepped(-half, half, 1),
                  random.uniform(-half, half));
    };
    const Vec3 low = point(4);
    const Aabb box{low, low + point(3).cwiseAbs()};
    const Vec3 from = point(12);
    const Vec3 to = point(12);
    const double t = nearest_share(from, to, box);
    ASSERT_TRUE(t >= 0 && t <= 1) << "case " << i;
    EXPECT_NEAR(distance(from + t * (to - from), box), oracle::segment_distance(from, to, box),
                1e-12)
        << "case " << i;
  }
}

}  // namespace
}  // namespace geom
