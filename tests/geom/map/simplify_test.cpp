#include "geom/map/simplify.h"

#include <gtest/gtest.h>

#include "geom/map/merge.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

// Boxes that nearly continue each other; far from the origin too, where coordinates are coarse.
BoxTable crowd(std::uint64_t seed, int count, double offset) {
  support::Random random(seed);
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(offset + random.below(12) + random.uniform(0, 0.2), random.below(12),
                   random.below(4));
    const Vec3 size(random.below(4), random.below(4) + random.uniform(0, 0.2), 1);
    boxes.push_back({low, low + size});
  }
  return support::table_of(std::move(boxes));
}

bool inside(const Aabb& inner, const Aabb& outer) {
  return contains(outer, inner.min) && contains(outer, inner.max);
}

oracle::Q squared_distance(const Vec3& p, const Aabb& box) {
  oracle::Q sum = 0;
  for (int k = 0; k < 3; ++k) {
    const oracle::Q below = oracle::Q(box.min[k]) - oracle::Q(p[k]);
    const oracle::Q above = oracle::Q(p[k]) - oracle::Q(box.max[k]);
    if (below > 0) sum += below * below;
    if (above > 0) sum += above * above;
  }
  return sum;
}

// The corners, and points on a grid and anywhere.
std::vector<Vec3> probes(const Aabb& box, support::Random& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < 150; ++i) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const double part = i < 8    ? (i >> k & 1)
                          : i < 50 ? random.below(9) / 8.0
                                   : random.uniform(0, 1);
      p[k] = std::clamp(box.min[k] + part * (box.max[k] - box.min[k]), box.min[k], box.max[k]);
    }
    points.push_back(p);
  }
  return points;
}

class SimplifyProperty : public testing::TestWithParam<double> {};

TEST_P(SimplifyProperty, HoldsEachInputInOneBoxAndStaysWithinTheSlackInRationals) {
  support::Random random(9);
  std::size_t fewer = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (const double slack : {0.0, 0.25, 0.7, 3.0}) {
      const BoxTable before = crowd(seed, 60, GetParam());
      const BoxTable after = simplify(before, slack).table;
      const std::size_t merged = merge(before).table.boxes.size();
      ASSERT_LE(after.boxes.size(), merged);
      fewer += after.boxes.size() < merged;
      for (const Aabb& box : before.boxes) {
        ASSERT_TRUE(std::any_of(after.boxes.begin(), after.boxes.end(),
                                [&](const Aabb& outer) { return inside(box, outer); }));
      }
      const oracle::Q most = oracle::Q(slack) * oracle::Q(slack);
      for (const Aabb& box : after.boxes) {
        for (const Vec3& p : probes(box, random)) {
          ASSERT_TRUE(std::any_of(before.boxes.begin(), before.boxes.end(), [&](const Aabb& input) {
            return squared_distance(p, input) <= most;
          })) << p.transpose();
        }
      }
    }
  }
  EXPECT_GT(fewer, 6u);
}

INSTANTIATE_TEST_SUITE_P(Offsets, SimplifyProperty, testing::Values(0.0, 5e5, 9e7));

TEST(Simplify, GivesTheSameForAnyNumberOfThreads) {
  const BoxTable before = crowd(3, 400, 0);
  Execution many;
  many.threads = 5;
  const BoxTable one = simplify(before, 0.5).table;
  const BoxTable other = simplify(before, 0.5, many).table;
  EXPECT_TRUE(one.boxes == other.boxes && one.ids == other.ids);
}

TEST(Simplify, FillsAGapOfUpToTwiceTheSlack) {
  const BoxTable before = support::table_of({{{0, 0, 0}, {4, 4, 4}}, {{5, 0, 0}, {9, 4, 4}}});
  EXPECT_EQ(simplify(before, 0.51).table.boxes.size(), 1u);
  EXPECT_EQ(simplify(before, 0.49).table.boxes.size(), 2u);
}

TEST(Simplify, KeepsLabelsApartAndLeavesNothingAlone) {
  BoxTable before = support::table_of({{{0, 0, 0}, {4, 4, 4}}, {{5, 0, 0}, {9, 4, 4}}});
  before.labels = {"", "keep-out"};
  before.label = {0, 1};
  EXPECT_EQ(simplify(before, 2).table.boxes.size(), 2u);
  EXPECT_TRUE(simplify(support::table_of({}), 1).table.boxes.empty());
}

TEST(Simplify, KeepsTimesApart) {
  BoxTable before = support::table_of({{{0, 0, 0}, {4, 4, 4}}, {{5, 0, 0}, {9, 4, 4}}});
  before.set_time(0, {0, 10});
  EXPECT_EQ(simplify(before, 2).table.boxes.size(), 2u);
  before.set_time(1, {0, 10});
  const BoxTable joined = simplify(before, 2).table;
  ASSERT_EQ(joined.boxes.size(), 1u);
  EXPECT_EQ(joined.time(0), (TimeSpan{0, 10}));
  // A third one that fills the corner between them, but not at these times, is no reason to join.
  before =
      support::table_of({{{0, 0, 0}, {4, 4, 4}}, {{4, 0, 0}, {8, 2, 4}}, {{4, 2, 0}, {8, 4, 4}}});
  before.set_time(0, {0, 10});
  before.set_time(1, {0, 10});
  before.set_time(2, {0, 9});
  EXPECT_EQ(simplify(before, 0.1).table.boxes.size(), 3u);
  before.set_time(2, {-1, 11});
  EXPECT_EQ(simplify(before, 0.1).table.boxes.size(), 2u);
}

}  // namespace
}  // namespace geom
