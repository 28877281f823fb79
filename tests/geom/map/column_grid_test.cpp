#include "geom/map/column_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "support/random_city.h"

namespace geom {
namespace {

std::vector<Vec3> scan(std::uint64_t seed, int count, const Vec3& center) {
  support::Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    // On cell borders and steps as often as not.
    const auto any = [&](double side) {
      return random.below(2) ? random.stepped(-side, side, 0.25) : random.uniform(-side, side);
    };
    points.push_back(center + Vec3(any(40), any(40), any(9)));
  }
  return points;
}

BoxTable boxes(const std::vector<Vec3>& points, const ColumnSpec& spec) {
  ColumnGrid grid(spec);
  for (const Vec3& p : points) grid.add(p);
  return grid.boxes("test");
}

TEST(ColumnGrid, HoldsEveryPointNearAndFarFromTheOrigin) {
  for (const double offset : {0.0, 5e5, -5.4e6}) {
    for (const double cell : {0.3, 1.0, 7.0}) {
      const auto points = scan(1, 2000, {offset, -offset, 100});
      const BoxTable table = boxes(points, {cell, 0.7, 1, false});
      for (const Vec3& p : points) {
        ASSERT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(), [&](const Aabb& box) {
          return contains(box, p);
        })) << p.transpose();
      }
    }
  }
}

TEST(ColumnGrid, HoldsAllWithinTheReachOfAPoint) {
  support::Random random(11);
  for (const double reach : {0.0, 0.3, 2.5}) {
    ColumnGrid grid({1, 0.5, 0, false});
    const auto points = scan(12, 50, {1000, -1000, 5});
    for (const Vec3& p : points) grid.add(p, reach);
    const BoxTable table = grid.boxes("test");
    for (int i = 0; i < 20000; ++i) {
      const auto any = [&] { return random.uniform(-reach, reach); };
      const Vec3 near = points[random.below(points.size())] + Vec3(any(), any(), any());
      ASSERT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(), [&](const Aabb& box) {
        return contains(box, near);
      })) << i;
    }
  }
}

TEST(ColumnGrid, DoesNotDependOnTheOrderOfThePoints) {
  auto points = scan(2, 3000, Vec3::Zero());
  const BoxTable one = boxes(points, {1, 0.5, 2, true});
  std::reverse(points.begin(), points.end());
  const BoxTable other = boxes(points, {1, 0.5, 2, true});
  EXPECT_TRUE(one.boxes == other.boxes);
  EXPECT_EQ(one.label, other.label);
}

TEST(ColumnGrid, IsTheSameOfManyPointsAtOnceForAnyNumberOfThreads) {
  for (const double reach : {0.0, 1.5}) {
    for (const double offset : {0.0, -5.4e6}) {
      auto points = scan(2, 40000, {offset, -offset, 0});
      const ColumnSpec spec{0.5, 0.25, 1, true};
      ColumnGrid one(spec);
      for (const Vec3& p : points) one.add(p, reach);
      const BoxTable expected = one.boxes("test");
      for (const unsigned threads : {1u, 2u, 7u}) {
        ColumnGrid grid(spec);
        grid.add(std::span(points).first(25000), reach, {threads, {}});
        grid.add(std::span(points).subspan(25000), reach, {threads, {}});
        const BoxTable table = grid.boxes("test", {threads, {}});
        EXPECT_TRUE(table.boxes == expected.boxes);
        EXPECT_EQ(table.label, expected.label);
        EXPECT_EQ(table.ids, expected.ids);
      }
    }
  }
}

TEST(ColumnGrid, IsTheSameOfPointsThatComeAFewAtATimeAndGoesOnAfterItsBoxes) {
  for (const double reach : {0.0, 20.0}) {  // metres: of few points, and of very many cells
    const auto points = scan(3, 1000, Vec3::Zero());
    const ColumnSpec spec{0.5, 0.25, 1, true};
    ColumnGrid one(spec);
    for (const Vec3& p : points) one.add(p, reach);
    ColumnGrid grid(spec);
    for (std::size_t i = 0; i < points.size(); i += 5) {
      grid.add(std::span(points).subspan(i, 5), reach);
      if (i == 500) {
        EXPECT_FALSE(grid.boxes("test").boxes.empty());
      }
    }
    const BoxTable expected = one.boxes("test");
    const BoxTable table = grid.boxes("test");
    EXPECT_TRUE(table.boxes == expected.boxes);
    EXPECT_EQ(table.label, expected.label);
    EXPECT_TRUE(grid.boxes("test").boxes == expected.boxes);
  }
}

TEST(ColumnGrid, IsTheSameWhereSomeIsSortedBetweenPoints) {
  const auto points = scan(13, 6000, {0, 0, 0});
  const ColumnSpec spec{1, 0.5, 0, false};
  ColumnGrid grid(spec);
  support::Random random(14);
  std::size_t sorted = 0;
  for (std::size_t i = 0; i < points.size(); i += 10) {
    grid.add(std::span(points).subspan(i, 10));
    for (std::uint64_t times = random.below(20); times > 0 && grid.sort_some(); --times) ++sorted;
  }
  EXPECT_GT(sorted, 500u);
  EXPECT_EQ(grid.boxes("test").boxes, boxes(points, spec).boxes);
  EXPECT_FALSE(grid.sort_some());
}

TEST(ColumnGrid, RefusesTheFirstPointThatIsTooFarForAnyNumberOfThreads) {
  std::vector<Vec3> points(40000, Vec3(1, 1, 1));
  points[30000] = {3e9, 0, 0};
  points[39000] = {4e9, 0, 0};
  for (const unsigned threads : {1u, 7u}) {
    ColumnGrid grid({1, 0.5, 2, false});
    try {
      grid.add(points, 0, {threads, {}});
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.fault().found, "3000000000");
    }
  }
}

TEST(ColumnGrid, LeavesNothingFreeBelowTheHighestReturnWhereUnknownIsBlocked) {
  const auto points = scan(3, 300, Vec3::Zero());
  const BoxTable table = boxes(points, {1, 0.5, 2, true});
  support::Random random(4);
  double low = 1e9;
  for (const Vec3& p : points) low = std::min(low, p.z());
  for (const Vec3& p : points) {
    const Vec3 below(p.x(), p.y(), random.uniform(low, p.z()));
    ASSERT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(),
                            [&](const Aabb& box) { return contains(box, below); }));
  }
  for (int i = 0; i < 500; ++i) {  // a place without returns is full to the top
    const Vec3 p(random.uniform(-39, 39), random.uniform(-39, 39), low + 0.1);
    ASSERT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(), [&](const Aabb& box) {
      return contains(box, p);
    })) << p.transpose();
  }
}

TEST(ColumnGrid, LeavesGapsFreeWhereUnknownIsFree) {
  const BoxTable table =
      boxes({{0.5, 0.5, 0}, {0.5, 0.5, 10}, {0.5, 0.5, 8.5}}, {1, 0.5, 2, false});
  ASSERT_EQ(table.boxes.size(), 2u);
  EXPECT_EQ(table.boxes[0].max.z(), 0.5);
  EXPECT_EQ(table.boxes[1].min.z(), 8.5);
  EXPECT_EQ(table.boxes[1].max.z(), 10.5);
}

TEST(ColumnGrid, RefusesARectangleBeyondThirtyOneBits) {
  EXPECT_THROW(boxes({{1e8, 0, 0}, {-1e8, 0, 0}}, {0.05, 0.5, 2, true}), InputError);
}

// The tile of these cells ends at index 2^31.
TEST(ColumnGrid, HoldsPointsOfTheLastCellsThatItTakes) {
  const double cell = 1e8 / (0x1p31 - 3);
  const ColumnSpec spec{cell, 0.5, 2, false};
  for (const double sign : {1.0, -1.0}) {
    const double last = sign * (0x1p31 - 4.5) * cell;
    const std::vector<Vec3> points = {{last, last, 1}, {last - sign * 9 * cell, last, 1}};
    const BoxTable table = boxes(points, spec);
    for (const Vec3& p : points) {
      EXPECT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(), [&](const Aabb& box) {
        return contains(box, p);
      })) << p.transpose();
    }
  }
  EXPECT_THROW(boxes({{1e8, 0, 0}}, {1e8 / 0x1p31, 0.5, 2, false}), InputError);
}

TEST(ColumnGrid, OfTheFinestStepsJoinsWhatIsLevel) {
  const BoxTable table = boxes({{0.5, 0.5, 0}, {0.5, 0.5, 1e-300}}, {1, 1e-300, 1e8, false});
  EXPECT_EQ(table.boxes.size(), 1u);
}

}  // namespace
}  // namespace geom
