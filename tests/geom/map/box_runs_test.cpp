#include "map/box_runs.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

using support::Random;

Aabb random_box(Random& random, double reach, double size) {
  const Vec3 low(random.uniform(-reach, reach), random.uniform(-reach, reach),
                 random.uniform(-9, 0));
  return {low, low + Vec3(random.uniform(0, size), random.uniform(0, size), random.uniform(0, 20))};
}

TEST(BoxRuns, FindsWhatIsAsHighInTheOrderOfTheBoxes) {
  Random random(3);
  for (const std::size_t count : {0u, 1u, 16u, 17u, 256u, 257u, 5000u}) {
    BoxRuns runs;
    std::vector<Aabb> all;
    while (all.size() < count) {  // some at a time
      std::vector<Aabb> some;
      for (std::size_t i = 0; i < 37 && all.size() + i < count; ++i) {
        some.push_back(random_box(random, 50, 4));
      }
      runs.add(some);
      all.insert(all.end(), some.begin(), some.end());
    }
    for (int k = 0; k < 100; ++k) {
      Aabb region = random_box(random, 55, 10);
      if (k % 3 == 0 && !all.empty()) region.min.x() = all[all.size() / 2].max.x();  // touches
      region.max = region.max.cwiseMax(region.min);
      std::vector<Aabb> expected;
      for (const Aabb& box : all) {
        if (is_as_high(box, region)) expected.push_back(box);
      }
      const std::vector<Aabb> found = runs.as_high_as(region);
      ASSERT_EQ(found.size(), expected.size()) << count << " boxes, region " << k;
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].min, expected[i].min);
        EXPECT_EQ(found[i].max, expected[i].max);
      }
    }
    EXPECT_EQ(runs.take().size(), count);
  }
}

TEST(BoxRuns, IsAsHighOnlyFromTheBottomToTheTop) {
  const Aabb region{{0, 0, 1}, {1, 1, 5}};
  EXPECT_TRUE(is_as_high({{1, 1, 1}, {2, 2, 5}}, region));
  EXPECT_FALSE(is_as_high({{0, 0, 1.1}, {2, 2, 5}}, region));
  EXPECT_FALSE(is_as_high({{0, 0, 1}, {2, 2, 4.9}}, region));
  EXPECT_FALSE(is_as_high({{1.1, 0, 1}, {2, 2, 5}}, region));
}

}  // namespace
}  // namespace geom
