#include "mesh/surface_runs.h"

#include <gtest/gtest.h>

#include "support/triangle_shapes.h"

namespace geom {
namespace {

constexpr CellRange kAll{-100000, 100000};

std::vector<SurfaceRun> runs_of(const TriangleCorners& corners, const CoverGrid& grid,
                                CellRange rows = kAll, CellRange columns = kAll) {
  SurfaceRuns runs(grid, rows, columns);
  runs.add(corners, 7);
  return std::move(runs).sorted();
}

TEST(SurfaceRuns, OfAFlatTriangleAreOneForEachRow) {
  const CoverGrid grid = CoverGrid::of(0.16, 10);  // cells of 0.1 m
  const auto runs = runs_of({Vec3(0.01, 0.01, 5), Vec3(9.99, 0.01, 5), Vec3(0.01, 4.99, 5)}, grid);
  ASSERT_EQ(runs.size(), 50u);
  EXPECT_EQ(runs[0].cells.first, 0);
  EXPECT_EQ(runs[0].cells.last, 100);
  for (const SurfaceRun& run : runs) {
    EXPECT_EQ(run.triangle, 7u);
    EXPECT_LE(run.low, 5);
    EXPECT_GE(run.high, 5);
    EXPECT_NEAR(run.low, run.high, 1e-12);
  }
}

TEST(SurfaceRuns, StayWithinRowsAndColumns) {
  const CoverGrid grid = CoverGrid::of(0.16, 10);
  const auto runs = runs_of({Vec3(0, 0, 0), Vec3(10, 0, 9), Vec3(0, 5, 3)}, grid, {3, 6}, {2, 9});
  ASSERT_FALSE(runs.empty());
  for (const SurfaceRun& run : runs) {
    EXPECT_TRUE(run.row >= 3 && run.row < 6);
    EXPECT_TRUE(run.cells.first >= 2 && run.cells.last <= 9);
  }
}

// Of a point in a cell, some run has its height; of a run, each cell has a point of its lowest and
// highest heights, to the rise. Runs of a row do not overlap.
TEST(SurfaceRuns, HaveTheHeightsOfTheirCells) {
  support::Random random(11);
  for (int round = 0; round < 400; ++round) {
    const TriangleMesh mesh = support::soup(static_cast<std::uint64_t>(round), 1);
    const TriangleCorners corners = {mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]};
    const CoverGrid grid = CoverGrid::of(random.uniform(0.2, 3), 26);
    const auto runs = runs_of(corners, grid);
    EXPECT_LE(static_cast<double>(runs.size()), 4 + 2 * most_runs(corners, grid)) << round;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const SurfaceRun& run = runs[i];
      ASSERT_LE(run.low, run.low_most);
      ASSERT_LE(run.high_least, run.high);
      ASSERT_LE(run.low_most - run.low, grid.rise);
      ASSERT_LE(run.high - run.high_least, grid.rise);
      ASSERT_LT(run.cells.first, run.cells.last);
      ASSERT_TRUE(i == 0 || runs[i - 1].row != run.row ||
                  runs[i - 1].cells.last == run.cells.first);
    }
    for (int n = 0; n < 300; ++n) {
      const Vec3 p = support::exact_point(random, mesh, 0);
      const long row = grid.last_from(p.y());
      const long cell = grid.last_from(p.x());
      const auto holds = [&](const SurfaceRun& run) {
        return run.row == row && run.cells.first <= cell && cell < run.cells.last &&
               run.low <= p.z() && p.z() <= run.high;
      };
      ASSERT_TRUE(std::any_of(runs.begin(), runs.end(), holds)) << "round " << round;
    }
  }
}

TEST(SurfaceRuns, OfASteepNeedleAreFewThoughItsBoxIsLarge) {
  const CoverGrid grid = CoverGrid::of(0.1, 1000);
  const TriangleCorners wall = {Vec3(0, 0, 0), Vec3(500, 500, 0), Vec3(500, 500, 80)};
  const double many = most_runs(wall, grid);
  EXPECT_LT(many, 40000);
  EXPECT_LE(static_cast<double>(runs_of(wall, grid).size()), many);
}

}  // namespace
}  // namespace geom
