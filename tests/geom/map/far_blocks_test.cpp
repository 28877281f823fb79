#include "geom/map/far_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace geom {
namespace {

std::vector<Aabb> crowd(support::Random& random, int count) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const bool long_one = random.below(8) == 0;
    const Vec3 low(random.uniform(-90, 90), random.uniform(-90, 90),
                   random.below(4) ? 0 : random.uniform(0, 80));
    const Vec3 size(random.uniform(0, long_one ? 120 : 9), random.uniform(0, 9),
                    random.uniform(0, 30));
    boxes.push_back({low, low + size});
  }
  return boxes;
}

bool holds(const Aabb& box, const Vec3& p) {
  return ((p - box.min).array() >= -1e-9).all() && ((box.max - p).array() >= -1e-9).all();
}

bool any_holds(std::span<const Aabb> boxes, const Vec3& p) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) { return holds(b, p); });
}

double distance_to_any(std::span<const Aabb> boxes, const Vec3& p) {
  double least = 1e300;
  for (const Aabb& box : boxes) {
    least = std::min(least, (p - p.cwiseMax(box.min).cwiseMin(box.max)).norm());
  }
  return least;
}

Vec3 anywhere_in(const Aabb& box, support::Random& random) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = random.uniform(box.min[k], box.max[k]);
  return p;
}

TEST(FarBlocksProperty, HoldEveryBoxAndReachNoFartherThanTwoCells) {
  support::Random random(3);
  for (int round = 0; round < 60; ++round) {
    const double cell = random.uniform(1, 40);
    const auto boxes = crowd(random, 1 + random.below(60));
    const auto blocks = far_blocks(boxes, cell);
    for (const Aabb& box : boxes) {
      for (int i = 0; i < 30; ++i) {
        const Vec3 p = anywhere_in(box, random);
        ASSERT_TRUE(any_holds(blocks, p)) << "round " << round << ": " << p.transpose();
      }
    }
    for (const Aabb& block : blocks) {
      for (int i = 0; i < 30; ++i) {
        ASSERT_LT(distance_to_any(boxes, anywhere_in(block, random)), 2 * cell) << round;
      }
    }
  }
}

TEST(FarBlocks, AreFewOfAWallOfStrips) {
  std::vector<Aabb> strips;
  for (int i = 0; i < 200; ++i) strips.push_back({{0.5 * i, 0, 0}, {0.5 * (i + 1), 60, 20}});
  EXPECT_LE(far_blocks(strips, 8).size(), 2u);
}

TEST(FarBlocks, LeaveABigBoxAndTheAirBelowABridge) {
  const std::vector<Aabb> zone = {{{0, 0, 100}, {5000, 5000, 120}}};
  ASSERT_EQ(far_blocks(zone, 8).size(), 1u);
  EXPECT_EQ(far_blocks(zone, 8)[0].min, zone[0].min);
  const std::vector<Aabb> bridge = {{{0, 0, 0}, {4, 4, 5}}, {{0, 0, 50}, {4, 4, 52}}};
  EXPECT_EQ(far_blocks(bridge, 8).size(), 2u);
}

}  // namespace
}  // namespace geom
