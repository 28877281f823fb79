#include "home/gmp_solid.h"

#include <gtest/gtest.h>

#include "geom/shape/hull.h"
#include "support/random_city.h"

namespace traj::exact {
namespace {

WholeBox whole_box(const geom::Aabb& box) { return {whole(box.min), whole(box.max)}; }

TEST(Solid, TouchesABoxThatItMeetsInOnePoint) {
  const Prism prism{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0, 1};
  EXPECT_FALSE(Solid(prism).apart(whole_box({{1, 1, 1}, {2, 2, 2}})));
  const double more = 1 + 0x1p-52;
  EXPECT_TRUE(Solid(prism).apart(whole_box({{more, 1, 1}, {2, 2, 2}})));
  // The hull with a point passes the box's edge in a slope, in one place of the edge.
  const geom::Aabb below{{4, -1, -1}, {6, 2, 2.5}};
  EXPECT_FALSE(Solid(prism, Vec3(10, 0, 5)).apart(whole_box({below.min, {6, 2, 2.5}})));
  EXPECT_FALSE(Solid(Prism{{{0, 0}}, 0, 0}, Vec3(8, 0, 4)).apart(whole_box(below)));
  EXPECT_FALSE(
      Solid(Prism{{{0, 0}}, 0, 0}, Vec3(8, 0, 4)).apart(whole_box({{6, -1, 0}, {9, 1, 3}})));
  EXPECT_TRUE(Solid(Prism{{{0, 0}}, 0, 0}, Vec3(8, 0, 4))
                  .apart(whole_box({{6 + 0x1p-49, -1, 0}, {9, 1, 3}})));
}

TEST(Solid, IsWithinABoxThatItTouchesFromInside) {
  const Prism prism{{{0, 0}, {3, 1}}, -1, 2};
  EXPECT_TRUE(Solid(prism).within(whole_box({{0, 0, -1}, {3, 1, 2}})));
  EXPECT_FALSE(Solid(prism).within(whole_box({{0, 0, -1}, {3, 1, 2 - 0x1p-52}})));
  EXPECT_FALSE(Solid(prism, Vec3(0, 0, 2.5)).within(whole_box({{0, 0, -1}, {3, 1, 2}})));
}

// Solids that hull_meets() calls apart are apart. Solids nearer than rounding may be said to meet.
TEST(Solid, AgreesWithRoundedNumbersOnRandomHulls) {
  support::Random random(7);
  int apart = 0;
  int met = 0;
  int surely = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto number = [&] { return random.uniform(-5, 5); };
    std::vector<Vec3> places;
    for (std::uint64_t n = 1 + random.below(5); n > 0; --n) {
      places.emplace_back(number(), number(), number());
    }
    const Prism prism = prism_around(places);
    std::optional<Vec3> to;
    std::vector<Vec3> hull = corners(prism);
    if (i % 3 > 0) {
      to = Vec3(4 * number(), 4 * number(), 4 * number());
      hull.push_back(*to);
    }
    const Vec3 low(2 * number(), 2 * number(), 2 * number());
    const geom::Aabb box{low, low + Vec3(1, 2, 3) * random.uniform(0.1, 2)};
    const bool exact = Solid(prism, to).apart(whole_box(box));
    ASSERT_EQ(exact, !geom::hull_meets(hull, box)) << "case " << i;
    const bool sure = RoughSolid(prism, to).surely_apart(box);
    ASSERT_LE(sure, exact) << "case " << i;
    surely += sure;
    (exact ? apart : met) += 1;
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(surely, 0.9 * apart);
  EXPECT_GT(met, 150);
}

TEST(RoughSolid, IsNeverSureOfATouch) {
  const Prism prism{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0, 1};
  EXPECT_FALSE(RoughSolid(prism).surely_apart({{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(RoughSolid(prism, Vec3(10, 0, 5)).surely_apart({{4, -1, -1}, {6, 2, 2.5}}));
  EXPECT_TRUE(RoughSolid(prism, Vec3(10, 0, 5)).surely_apart({{4, 3, -1}, {6, 4, 2.5}}));
}

}  // namespace
}  // namespace traj::exact
