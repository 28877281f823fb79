#include "geom/map/detail_levels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace geom {
namespace {

bool holds(const Aabb& outer, const Vec3& p) {
  return ((p - outer.min).array() >= -1e-9).all() && ((outer.max - p).array() >= -1e-9).all();
}

TEST(DetailLevelsProperty, BlocksOfATileAndGroupHoldItsBoxes) {
  support::Random random(12);
  std::vector<Aabb> boxes;
  std::vector<std::uint32_t> group;
  for (int house = 0; house < 200; ++house) {
    const Vec3 at(random.uniform(-500, 500), random.uniform(-500, 500), 0);
    for (int i = 0; i < 20; ++i) {
      const Vec3 low = at + Vec3(i, random.uniform(0, 1), 0);
      boxes.push_back({low, low + Vec3(1, random.uniform(5, 20), random.uniform(3, 60))});
      group.push_back(static_cast<std::uint32_t>(house));
    }
  }
  const DetailLevels levels = detail_levels(boxes, group);
  ASSERT_EQ(levels.first.back(), boxes.size());
  ASSERT_GE(levels.far.size(), 2u);
  EXPECT_LT(levels.far.back().blocks.size(), levels.far.front().blocks.size());
  for (const FarLevel& level : levels.far) {
    ASSERT_EQ(level.first.size(), levels.first.size());
    for (std::size_t t = 0; t + 1 < levels.first.size(); ++t) {
      for (std::uint32_t i = levels.first[t]; i < levels.first[t + 1]; ++i) {
        const Aabb& box = boxes[levels.order[i]];
        const Vec3 p = box.min + random.uniform(0, 1) * (box.max - box.min);
        bool held = false;
        for (std::uint32_t k = level.first[t]; k < level.first[t + 1]; ++k) {
          held = held || (holds(level.blocks[k], p) &&
                          group[levels.order[level.of[k]]] == group[levels.order[i]]);
        }
        ASSERT_TRUE(held) << "cell " << level.cell << ", box " << i;
      }
    }
  }
  std::vector<std::uint32_t> sorted = levels.order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
}

TEST(DetailLevels, OfOneBoxAreThatBox) {
  const std::vector<Aabb> one = {{{1, 2, 0}, {1, 2, 3}}};
  const std::vector<std::uint32_t> group = {5};
  const DetailLevels levels = detail_levels(one, group);
  EXPECT_EQ(levels.first, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(levels.far.front().blocks.size(), 1u);
}

}  // namespace
}  // namespace geom
