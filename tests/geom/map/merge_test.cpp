#include "geom/map/merge.h"

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

// Boxes of all sizes, from a metre to the whole map: each is found by those inside it.
TEST(Merge, DropsWhatIsContainedWhateverTheSizes) {
  support::Random random(4);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 600; ++i) {
    const double size = std::ldexp(1.0, random.below(11));
    const Vec3 low(random.stepped(-1000, 1000, 1), random.stepped(-1000, 1000, 1), 0);
    boxes.push_back({low, low + Vec3(size, random.below(2) ? size : 1, 5)});
  }
  const BoxTable before = support::table_of(boxes);
  const BoxTable after = merge(before).table;
  ASSERT_LT(after.boxes.size(), boxes.size() - 50);
  for (std::size_t i = 0; i < after.boxes.size(); ++i) {
    for (std::size_t k = 0; k < after.boxes.size(); ++k) {
      ASSERT_FALSE(i != k && merged(after.boxes[i], after.boxes[k]) == after.boxes[k]);
    }
  }
  EXPECT_EQ(oracle::not_held(before.boxes, after.boxes), 0u);
  EXPECT_EQ(oracle::not_held(after.boxes, before.boxes), 0u);
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

// Within a time, at its ends, and between two.
std::vector<Aabb> there_at(const BoxTable& table, double t) {
  std::vector<Aabb> out;
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    if (table.time(i).meets({t, t})) out.push_back(table.boxes[i]);
  }
  return out;
}

TEST(Merge, LeavesTheUnionTheSameAtEachInstant) {
  std::size_t fewer = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    BoxTable before = crowd(seed, 80);
    support::Random random(seed + 100);
    for (std::size_t i = 0; i < before.boxes.size(); ++i) {
      const double from = random.below(3);
      if (random.below(3)) before.set_time(i, {from, from + random.below(3)});
    }
    const BoxTable after = merge(before).table;
    fewer += after.boxes.size() < before.boxes.size();
    for (double t = -0.5; t <= 5; t += 0.5) {
      ASSERT_EQ(oracle::not_held(there_at(before, t), there_at(after, t)), 0u) << seed << ' ' << t;
      ASSERT_EQ(oracle::not_held(there_at(after, t), there_at(before, t)), 0u) << seed << ' ' << t;
    }
  }
  EXPECT_GT(fewer, 10u);
}

}  // namespace
}  // namespace geom
