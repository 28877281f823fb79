#include "geom/cloud/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/random_city.h"

namespace geom {
namespace {

// By looking at each pair.
std::vector<std::vector<std::size_t>> oracle(const std::vector<Vec3>& points, double tolerance) {
  std::vector<std::size_t> group(points.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        const bool near = (points[i] - points[k]).squaredNorm() <= tolerance * tolerance;
        if (!near || group[i] <= group[k]) continue;
        group[i] = group[k];
        changed = true;
      }
    }
  }
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t g = 0; g < points.size(); ++g) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (group[i] == g) members.push_back(i);
    }
    if (!members.empty()) out.push_back(members);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return out;
}

TEST(Clusters, AreThoseOfEveryPair) {
  support::Random random(4);
  for (int round = 0; round < 200; ++round) {
    const double side = random.uniform(1, 40);
    const double tolerance = random.below(2) ? 1 : random.uniform(0.3, 4);
    const Vec3 centre = round % 2 ? Vec3(500000, 5400000, 100) : Vec3::Zero();
    std::vector<Vec3> points;
    for (int i = 0; i < 150; ++i) {
      const auto any = [&] {
        return random.below(2) ? random.stepped(0, side, tolerance) : random.uniform(0, side);
      };
      points.push_back(centre + Vec3(any(), any(), any() / 4));
    }
    ASSERT_EQ(clusters(points, tolerance), oracle(points, tolerance)) << round;
  }
}

TEST(Clusters, AStepOfTheToleranceLinks) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2.0000001, 0, 0}, {9, 9, 9}};
  EXPECT_EQ(clusters(points, 1), (std::vector<std::vector<std::size_t>>{{0, 1}, {2}, {3}}));
  EXPECT_TRUE(clusters({}, 1).empty());
}

// Two dense walls a little further apart than the tolerance: each pair of points would take
// minutes.
TEST(Clusters, ManyPointsNearEachOtherTakeNoLonger) {
  support::Random random(8);
  std::vector<Vec3> points;
  for (int i = 0; i < 200000; ++i) {
    points.push_back({i % 2 ? 0.0 : 1.01, random.uniform(0, 2), random.uniform(0, 2)});
  }
  const auto found = clusters(points, 1);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].size(), 100000u);
}

}  // namespace
}  // namespace geom
