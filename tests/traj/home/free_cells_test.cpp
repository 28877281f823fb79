#include "home/free_cells.h"

#include <gtest/gtest.h>

#include "home/few_corners.h"

namespace traj {
namespace {

const PlanBox kBounds{{0, 0}, {100, 100}};

Outline square(double x, double y, double size) {
  return outline_of({{x, y}, {x + size, y + size}});
}

double area_of(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * twice;
}

TEST(RingsBetween, IsTheBoundsWhereNothingStands) {
  const auto rings = rings_between({{square(20, 20, 5)}}, {}, kBounds);
  ASSERT_TRUE(rings);
  EXPECT_EQ(rings->outer.size(), 4u);
  EXPECT_EQ(area_of(rings->outer), 1e4);
  EXPECT_TRUE(rings->holes.empty());
}

TEST(RingsBetween, GoesAroundABoxWithinALoop) {
  const std::vector<Outline> loop = {
      outline_of({{20, 20}, {80, 25}}), outline_of({{75, 20}, {80, 80}}),
      outline_of({{20, 75}, {80, 80}}), outline_of({{20, 20}, {25, 80}})};
  const PlanBox box[] = {{{45, 45}, {55, 55}}};
  const auto rings = rings_between(loop, box, kBounds);
  ASSERT_TRUE(rings);
  EXPECT_GT(area_of(rings->outer), 3600);
  ASSERT_EQ(rings->holes.size(), 1u);
  EXPECT_EQ(area_of(rings->holes[0]), -100) << "clockwise";
}

TEST(RingsBetween, JoinsWhatIsApart) {
  const PlanBox wall[] = {{{48, 10}, {52, 100}}};
  const auto rings = rings_between({{square(10, 80, 5), square(80, 80, 5)}}, wall, kBounds);
  ASSERT_TRUE(rings) << "below the wall";
  EXPECT_TRUE(rings->holes.empty());
  const PlanBox whole[] = {{{48, 0}, {52, 100}}};
  EXPECT_FALSE(rings_between({{square(10, 80, 5), square(80, 80, 5)}}, whole, kBounds));
}

TEST(RingsBetween, RefusesARegionInABox) {
  const PlanBox box[] = {{{10, 10}, {20, 20}}};
  EXPECT_FALSE(rings_between({{square(15, 15, 20)}}, box, kBounds));
}

// Two boxes that touch at a corner, and an area on either side of that.
TEST(RingsBetween, IsSimpleWhereBoxesTouchAtACorner) {
  const PlanBox boxes[] = {{{20, 20}, {50, 50}}, {{50, 50}, {80, 80}}};
  const std::vector<Outline> around = {outline_of({{5, 5}, {95, 10}}),
                                       outline_of({{90, 5}, {95, 95}}),
                                       outline_of({{5, 90}, {95, 95}}),
                                       outline_of({{5, 5}, {10, 95}}),
                                       square(55, 30, 10),
                                       square(30, 55, 10)};
  const auto rings = rings_between(around, boxes, kBounds);
  ASSERT_TRUE(rings);
  EXPECT_TRUE(is_apart(rings->outer));
  for (const auto& hole : rings->holes) EXPECT_TRUE(is_apart(hole));
}

}  // namespace
}  // namespace traj
