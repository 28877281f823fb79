#include "geom/cloud/pcl_filters.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "support/failing_memory.h"
#include "support/random_city.h"

namespace geom {
namespace {

using support::FailingMemory;

CloudPoints some_points() {
  support::Random random(7);
  CloudPoints out;
  for (int i = 0; i < 300; ++i)
    out.push_back({{random.uniform(0, 9), random.uniform(0, 9), random.uniform(0, 9)}});
  out.push_back({{500, 500, 500}});
  return out;
}

std::vector<Vec3> positions(const CloudPoints& points) {
  std::vector<Vec3> out;
  for (const CloudPoint& p : points) out.push_back(p.position);
  return out;
}

TEST(PclFilters, LeaveOutWhatIsFarAndWhatShares) {
  const CloudPoints points = some_points();
  EXPECT_EQ(without_outliers(points, 5, 3).size(), 300u);
  const CloudPoints sampled = one_per_voxel(points, 100, "scan");
  EXPECT_LT(sampled.size(), 20u);
  EXPECT_EQ(sampled.back().position, points.back().position);
}

// PCL prints a message where it lacks memory, and goes on without some of the points.
class ShortOfMemory : public testing::TestWithParam<FailingMemory::Then> {};

TEST_P(ShortOfMemory, NeverLeavesOutPoints) {
  const CloudPoints points = some_points();
  const std::function<CloudPoints()> filters[] = {[&] { return without_outliers(points, 5, 3); },
                                                  [&] { return one_per_voxel(points, 2, "scan"); }};
  for (const auto& filter : filters) {
    const std::vector<Vec3> right = positions(filter());
    bool failed = true;
    for (long n = 0; failed; ++n) {
      std::optional<CloudPoints> kept;
      try {
        const FailingMemory short_of_memory(n, GetParam());
        kept = filter();
      } catch (const std::exception&) {
      }
      failed = FailingMemory::any_failed();
      ASSERT_TRUE(failed || kept) << "allocation " << n;
      ASSERT_EQ(kept ? positions(*kept) : right, right) << "allocation " << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MemoryThen, ShortOfMemory,
                         testing::Values(FailingMemory::Then::works, FailingMemory::Then::fails));

}  // namespace
}  // namespace geom
