#include "footprints/place.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"

namespace footprints {
namespace {

// Rectangles of cells of a height model, `cell` units wide, far from the middle of its zone, where
// its rows lean by a degree and more.
Source grid_of(const std::string& crs, const geom::Vec2& corner, double cell) {
  Source out;
  out.crs = crs;
  out.grid = CellGrid{{corner.x(), cell, 0, corner.y(), 0, -cell}, {}};
  for (const CellGrid::Cells& cells : {CellGrid::Cells{0, 1, 0, 1},
                                       {1, 2, 0, 1},
                                       {0, 40, 1, 2},
                                       {0, 1, 2, 60},
                                       {1, 30, 2, 60},
                                       {30, 130, 2, 3}}) {
    geom::Footprint f;
    f.id = out.footprints.size();
    f.top = 10;
    for (const auto& [column, row] : {std::pair{cells.first_column, cells.first_row},
                                      {cells.last_column, cells.first_row},
                                      {cells.last_column, cells.last_row},
                                      {cells.first_column, cells.last_row}}) {
      f.polygon.outer.push_back(out.grid->corner(column, row));
    }
    out.footprints.push_back(f);
    out.grid->of.push_back(cells);
  }
  return out;
}

Source projected(Source source, double slack) {
  const Projector projector(source, "t.tif", std::nullopt, false);
  project(source, projector, slack);
  return source;
}

// Boxes hold the rectangle with all corners of cells along its sides, and keep the slack outside
// it.
void expect_boxes_within_slack(const Source& grid, double slack, const std::string& what) {
  const Source exact = projected(grid, 0);
  const geom::BoxTable table = geom::boxes_of(projected(grid, slack).footprints, slack, {});
  for (const geom::Footprint& f : exact.footprints) {
    std::vector<geom::Rectangle> rectangles;
    for (std::size_t i = 0; i < table.boxes.size(); ++i) {
      const geom::Aabb& box = table.boxes[i];
      if (table.ids[i] == f.id) rectangles.push_back({box.min.head<2>(), box.max.head<2>()});
    }
    EXPECT_TRUE(oracle::exactly_covered(f.polygon, rectangles)) << what << ", rectangle " << f.id;
    for (const geom::Rectangle& r : rectangles) {
      EXPECT_LE(oracle::furthest_outside(f.polygon, r, 1e-3 * slack, slack), slack * 1.001)
          << what << ", rectangle " << f.id;
    }
  }
}

TEST(Project, CellsOfAHeightModelAreHeldWithinTheSlack) {
  for (const double cell : {1.0, 10.0}) {
    for (const double slack : {0.5, 2.0}) {
      expect_boxes_within_slack(grid_of("EPSG:32633", {600000, 5340000}, cell), slack,
                                std::to_string(cell) + " m, " + std::to_string(slack));
    }
  }
  expect_boxes_within_slack(grid_of("EPSG:4326", {24, 60}, 1.0 / 36000), 0.5, "degrees");
}

// Four corners are enough of most rectangles, and never where their sides bend by more than a
// hundredth of the slack.
TEST(Project, SidesOfManyCellsStayStraightOnlyWhereTheyAre) {
  const Source small = projected(grid_of("EPSG:32633", {600000, 5340000}, 1), 0.5);
  for (const geom::Footprint& f : small.footprints) {
    EXPECT_EQ(f.polygon.outer.size(), 4u);
    EXPECT_LE(f.bulge, 0.005);
  }
  const Source large = projected(grid_of("EPSG:32633", {600000, 5340000}, 3000), 0.5);
  EXPECT_EQ(large.footprints[0].polygon.outer.size(), 4u);
  EXPECT_EQ(large.footprints[2].polygon.outer.size(), 82u);
  EXPECT_EQ(large.footprints[2].bulge, 0);
}

// The same bits come out whether a point is converted alone or among others.
TEST(Projector, ConvertsEachPointAsIfItWereAlone) {
  Source source = grid_of("EPSG:32633", {600000, 5340000}, 10);
  const Projector projector(source, "t.tif", std::nullopt, false);
  std::vector<geom::Vec2> together;
  for (int i = 0; i < 3000; ++i) together.push_back({600000.0 + i % 50 * 10, 5340000.0 + i % 70});
  const std::vector<geom::Vec2> before = together;
  projector.convert(together);
  for (std::size_t i = 0; i < before.size(); ++i) {
    std::vector<geom::Vec2> alone{before[i]};
    projector.convert(alone);
    EXPECT_EQ(alone.front(), together[i]);
  }
}

TEST(Projector, RefusesAPointThatCannotBeConverted) {
  Source source = grid_of("EPSG:32633", {600000, 5340000}, 10);
  const Projector projector(source, "t.tif", std::nullopt, false);
  std::vector<geom::Vec2> points{{600000, 5340000}, {1e30, 1e30}, {600000, 5340000}};
  EXPECT_THROW(projector.convert(points), geom::InputError);
}

}  // namespace
}  // namespace footprints
