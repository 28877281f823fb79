#include "geom/merge.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "support/union_oracle.h"

namespace geom {
namespace {

// Boxes on a small grid, so that many touch, contain or continue each other; some flat.
BoxTable crowd(std::uint64_t seed, int count) {
  support::Random random(seed);
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(random.below(12), random.below(12), random.below(4));
    const Vec3 size(random.below(4), random.below(4), 1 + random.below(3));
    boxes.push_back({low, low + size});
  }
  return support::table_of(std::move(boxes));
}

TEST(UnionOracle, SeesWhatIsMissing) {
  const std::vector<Aabb> halves = {{{0, 0, 0}, {1, 2, 2}}, {{1, 0, 0}, {2, 2, 2}}};
  EXPECT_TRUE(oracle::held({{0, 0, 0}, {2, 2, 2}}, halves));
  EXPECT_FALSE(oracle::held({{0, 0, 0}, {2, 2, 2.5}}, halves));
  EXPECT_FALSE(oracle::held({{0, 0, 3}, {2, 2, 3}}, halves));
  EXPECT_TRUE(oracle::held({{0, 0, 2}, {2, 2, 2}}, halves));
}

TEST(Merge, LeavesTheUnionExactlyTheSame) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const BoxTable before = crowd(seed, 80);
    const Merged after = merge(before);
    EXPECT_LT(after.table.boxes.size(), before.boxes.size());
    EXPECT_EQ(before.boxes.size(), after.table.boxes.size() + after.contained + after.joined);
    ASSERT_EQ(oracle::not_held(before.boxes, after.table.boxes), 0u) << seed;
    ASSERT_EQ(oracle::not_held(after.table.boxes, before.boxes), 0u) << seed;
  }
}

TEST(Merge, FindsNothingTheSecondTime) {
  const Merged once = merge(crowd(7, 200));
  const Merged twice = merge(once.table);
  EXPECT_EQ(twice.contained + twice.joined, 0u);
}

TEST(Merge, KeepsLabelsApartUnlessContained) {
  BoxTable table =
      support::table_of({{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{0, 0, 0}, {1, 1, 0.5}}});
  table.labels = {"", "keep-out"};
  table.label = {0, 1, 1};
  const Merged after = merge(table);
  EXPECT_EQ(after.table.boxes.size(), 2u);
  EXPECT_EQ(after.contained, 1u);
}

TEST(Simplify, CoversAndStaysWithinTheSlack) {
  support::Random random(9);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    BoxTable before = crowd(seed, 60);
    for (Aabb& box : before.boxes) box = grow(box, Vec3::Constant(random.uniform(0, 0.3)));
    const double slack = 0.5;
    const Simplified after = simplify(before, slack);
    EXPECT_LE(after.table.boxes.size(), merge(before).table.boxes.size());
    for (const Aabb& box : before.boxes) {
      ASSERT_TRUE(std::any_of(after.table.boxes.begin(), after.table.boxes.end(),
                              [&](const Aabb& outer) {
                                return contains(outer, box.min) && contains(outer, box.max);
                              }) ||
                  oracle::not_held(std::span(&box, 1), after.table.boxes) == 0);
    }
    for (const Aabb& box : after.table.boxes) {
      for (int i = 0; i < 300; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) {
          p[k] = i < 8 ? ((i >> k & 1) ? box.max[k] : box.min[k])
                       : random.uniform(box.min[k], box.max[k]);
        }
        double nearest = 1e9;
        for (const Aabb& inner : before.boxes) nearest = std::min(nearest, distance(p, inner));
        ASSERT_LE(nearest, slack * (1 + 1e-9)) << p.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace geom
