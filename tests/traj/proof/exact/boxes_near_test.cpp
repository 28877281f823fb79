#include "proof/exact/boxes_near.h"

#include <gtest/gtest.h>

#include <random>

namespace traj::exact {
namespace {

using geom::Aabb;
using geom::Vec3;

TEST(BoxesNear, FindsNothingForNoRegions) {
  const std::vector<Aabb> boxes{{{0, 0, 0}, {1, 1, 1}}};
  EXPECT_TRUE(boxes_near(boxes, Vec3::Ones(), {}).empty());
  const std::vector<Aabb> regions{{{0, 0, 0}, {1, 1, 1}}};
  EXPECT_TRUE(boxes_near({}, Vec3::Ones(), regions).front().empty());
}

TEST(BoxesNear, ABoxThatTouchesIsNear) {
  const std::vector<Aabb> boxes{{{3, 0, 0}, {4, 1, 1}}, {{3.5, 0, 0}, {4, 1, 1}}};
  const std::vector<Aabb> regions{{{0, 0, 0}, {1, 1, 1}}};
  EXPECT_EQ(boxes_near(boxes, {2, 0, 0}, regions).front(), (std::vector<std::size_t>{0}));
}

TEST(BoxesNear, AgreesWithALookAtEveryBox) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 100);
  std::uniform_real_distribution<double> size(0, 6);
  const auto box = [&] {
    const Vec3 low(place(random), place(random), place(random));
    return Aabb{low, low + Vec3(size(random), size(random), size(random))};
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<Aabb> boxes(400);
    for (Aabb& one : boxes) one = box();
    std::vector<Aabb> regions(1 + static_cast<std::size_t>(round));
    for (Aabb& one : regions) one = box();
    const Vec3 reach(size(random), size(random), size(random));
    const auto found = boxes_near(boxes, reach, regions);
    ASSERT_EQ(found.size(), regions.size());
    for (std::size_t r = 0; r < regions.size(); ++r) {
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool apart = ((boxes[i].min - reach).array() > regions[r].max.array()).any() ||
                           ((boxes[i].max + reach).array() < regions[r].min.array()).any();
        if (!apart) expected.push_back(i);
      }
      EXPECT_EQ(found[r], expected) << "round " << round << ", region " << r;
    }
  }
}

}  // namespace
}  // namespace traj::exact
