#include "geom/map/box_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(BoxIndex, HoldsOnlyWhatWasAdded) {
  BoxIndex index(10);
  EXPECT_TRUE(index.near({{-1e6, -1e6, 0}, {1e6, 1e6, 1}}).empty());
  index.add(7, {{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(index.near({{0, 0, 0}, {1, 1, 1}}), std::vector<std::size_t>{7});
  EXPECT_TRUE(index.near({{100, 100, 0}, {101, 101, 1}}).empty());
}

// Boxes of all sizes, that often touch; against a look at each.
TEST(BoxIndex, FindsEveryBoxThatMeetsARegionOnceAndInOrder) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    support::Random random(seed);
    const auto box = [&](double largest) {
      const Vec3 low(random.stepped(-200, 200, 1), random.stepped(-200, 200, 1), 0);
      const double side = random.below(5) ? 3 : largest;
      return Aabb{low, low + Vec3(random.stepped(0, side, 1), random.stepped(0, side, 1), 9)};
    };
    std::vector<Aabb> boxes;
    BoxIndex index(random.uniform(0.5, 20));
    for (std::size_t i = 0; i < 200; ++i) {
      boxes.push_back(box(300));
      index.add(i, boxes.back());
    }
    for (int query = 0; query < 100; ++query) {
      const Aabb region = box(60);
      const auto near = index.near(region);
      ASSERT_TRUE(std::is_sorted(near.begin(), near.end()));
      ASSERT_EQ(std::adjacent_find(near.begin(), near.end()), near.end());
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!overlap(boxes[i], region)) continue;
        ASSERT_TRUE(std::binary_search(near.begin(), near.end(), i))
            << "seed " << seed << ", query " << query << ", box " << i;
      }
    }
  }
}

TEST(BoxIndex, LeavesOutMostOfWhatIsFar) {
  BoxIndex index(10);
  for (std::size_t i = 0; i < 1000; ++i) {
    const double x = static_cast<double>(i) * 10;
    index.add(i, {{x, 0, 0}, {x + 5, 5, 5}});
  }
  EXPECT_LE(index.near({{500, 0, 0}, {520, 5, 5}}).size(), 5u);
}

TEST(IndexCell, IsTheMeanSideAndAtLeastAMetre) {
  EXPECT_EQ(index_cell({}), 1);
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {4, 2, 90}}, {{0, 0, 0}, {1, 8, 90}}};
  EXPECT_EQ(index_cell(boxes), 6);
  EXPECT_EQ(index_cell(std::vector<Aabb>{{{0, 0, 0}, {0.1, 0.1, 9}}}), 1);
}

}  // namespace
}  // namespace geom
