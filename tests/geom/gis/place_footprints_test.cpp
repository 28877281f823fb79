#include "geom/gis/place_footprints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "support/cover_oracle.h"
#include "support/exact_cover.h"
#include "support/memory_raster.h"
#include "support/random_city.h"
#include "support/reading.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

// Rectangles of cells of a height model, `cell` units wide, far from the middle of its zone, where
// its rows lean by a degree and more.
Source grid_of(const std::string& crs, const geom::Vec2& corner, double cell) {
  Source out;
  if (!crs.empty()) out.crs = geom::ProjReference::of(crs);
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

// A height model of 10 x 10 cells as a text grid, with trees on a slope.
std::string write_heights(const support::TemporaryFolder& folder, double cell) {
  support::Random random(4);
  std::ofstream out(folder / "h.asc");
  out << "ncols 10\nnrows 10\nxllcorner 600000\nyllcorner 5340000\ncellsize " << cell
      << "\nNODATA_value -9999\n";
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      const int tree = random.below(4) == 0 ? random.below(6) : 0;
      const int height = random.below(20) == 0 ? -9999 : 100 + (row + column) / 4 + tree;
      out << height << (column < 9 ? ' ' : '\n');
    }
  }
  std::ofstream(folder / "h.prj") << "PROJCS[\"UTM 33N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\","
                                     "SPHEROID[\"WGS 84\",6378137,298.257223563]],"
                                     "PRIMEM[\"Greenwich\",0],UNIT[\"degree\","
                                     "0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
                                     "PARAMETER[\"latitude_of_origin\",0],"
                                     "PARAMETER[\"central_meridian\",15],"
                                     "PARAMETER[\"scale_factor\",0.9996],"
                                     "PARAMETER[\"false_easting\",500000],"
                                     "PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]";
  return folder / "h.asc";
}

// Of each cell, how high its rectangles are; 0 for none.
std::vector<double> tops_of(const Source& source) {
  std::vector<double> tops(100);
  for (const geom::Footprint& f : source.footprints) {
    const CellGrid::Cells& cells = source.grid->of[f.id];
    for (int row = cells.first_row; row < cells.last_row; ++row) {
      for (int column = cells.first_column; column < cells.last_column; ++column) {
        double& top = tops[static_cast<std::size_t>(10 * row + column)];
        top = std::max(top, f.top);
      }
    }
  }
  return tops;
}

// Rows that lean little, by much of the slack, and by more than it.
TEST(ReadRaster, RectanglesAreAsHighAsTheirCellsAndBoxesKeepTheSlack) {
  std::vector<double> expected;
  for (const double cell : {1.0, 10.0, 100.0}) {
    const support::TemporaryFolder folder;
    const Source source = read_raster(write_heights(folder, cell), "h.asc", {});
    if (expected.empty()) {
      std::ifstream in(folder / "h.asc");
      for (std::string line; std::getline(in, line);) {
        if (line.starts_with("NODATA")) break;
      }
      for (double height = 0; in >> height;) expected.push_back(std::max(height, 0.0));
      ASSERT_EQ(expected.size(), 100u);
    }
    EXPECT_EQ(tops_of(source), expected) << cell;
    expect_boxes_within_slack(source, 0.5, std::to_string(cell) + " m");
  }
}

TEST(LeanOf, IsThatOfTheRowsOnTheMap) {
  const CellGrid utm{{600000, 10, 0, 5340000, 0, -10}, {}};
  const CellLean lean = lean_of(utm, 100, 100, geom::ProjReference::of("EPSG:32633"), std::nullopt);
  EXPECT_NEAR(lean.column, 0.175, 0.003);  // a degree of convergence
  EXPECT_NEAR(lean.row, 0.175, 0.003);
  const CellLean none = lean_of(utm, 100, 100, std::nullopt, std::nullopt);
  EXPECT_EQ(none.column, 0);
  EXPECT_EQ(none.row, 0);
  const CellGrid nowhere{{1e30, 10, 0, 1e30, 0, -10}, {}};
  EXPECT_TRUE(std::isinf(
      lean_of(nowhere, 100, 100, geom::ProjReference::of("EPSG:32633"), std::nullopt).column));
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

// A rectangle between two corners of degrees or metres.
Source rectangle_of(const std::string& crs, const geom::Vec2& low, const geom::Vec2& high) {
  Source out;
  if (!crs.empty()) out.crs = geom::ProjReference::of(crs);
  geom::Footprint& f = out.footprints.emplace_back();
  f.top = 10;
  f.polygon.outer = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  return out;
}

double distance_to_edge(const geom::Vec2& p, const geom::Vec2& a, const geom::Vec2& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

// The most that a point of the source's southern edge is outside the rectangle on the map.
double furthest_outside(const Source& source) {
  const geom::Vec2 west = source.footprints[0].polygon.outer[0];
  const geom::Vec2 east = source.footprints[0].polygon.outer[1];
  Source map = source;
  const Projector projector(map, "t.geojson", std::nullopt, false);
  project(map, projector, 0.5);
  std::vector<geom::Vec2> points;
  for (int i = 0; i <= 5000; ++i) points.emplace_back(west + (east - west) * (i / 5000.0));
  projector.convert(points);
  const auto& ring = map.footprints[0].polygon.outer;
  double furthest = 0;
  for (const geom::Vec2& p : points) {
    double away = 1e9;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      away = std::min(away, distance_to_edge(p, ring[i], ring[(i + 1) % ring.size()]));
    }
    furthest = std::max(furthest, away);
  }
  return furthest;
}

TEST(Project, FollowsEdgesThatAreStraightInTheSource) {
  const auto degrees = [](double length) {
    return rectangle_of("EPSG:4326", {10, 60}, {10 + length / 55800, 60.0005});
  };
  for (const double length : {20.0, 60.0, 200.0, 1000.0, 10000.0}) {
    EXPECT_LE(furthest_outside(degrees(length)), 1e-4) << length;
  }
  EXPECT_LE(furthest_outside(rectangle_of("EPSG:3857", {1.1e6, 8.4e6}, {1.11e6, 8.4001e6})), 1e-4);
  EXPECT_LE(furthest_outside(rectangle_of("EPSG:32633", {7e5, 5e6}, {7.4e5, 5.0001e6})), 1e-4);
  EXPECT_LE(furthest_outside(rectangle_of("EPSG:4326", {-10, -1}, {-9.9, 1})), 1e-4);
}

TEST(Project, AddsNoCornersToHouses) {
  const auto corners = [](const Source& source) {
    return projected(source, 0.5).footprints[0].polygon.outer.size();
  };
  EXPECT_EQ(corners(rectangle_of("EPSG:4326", {10, 60}, {10.0004, 60.0004})), 4u);
  EXPECT_EQ(corners(rectangle_of("EPSG:32633", {7e5, 5e6}, {7.002e5, 5.0002e6})), 4u);
  EXPECT_LT(corners(rectangle_of("EPSG:4326", {10, 60}, {10.1, 60.0001})), 250u);
}

TEST(Project, BringsABulgeToTheMap) {
  Source degrees = rectangle_of("EPSG:4326", {10, 60}, {10.0004, 60.0004});
  degrees.footprints[0].bulge = 1e-7;
  const double bulge = projected(degrees, 0.5).footprints[0].bulge;
  EXPECT_GE(bulge, 1e-7 * 111400);
  EXPECT_LE(bulge, 1e-7 * 130000);
  Source metres = rectangle_of("", {0, 0}, {20, 10});
  metres.footprints[0].bulge = 0.01;
  EXPECT_EQ(projected(metres, 0.5).footprints[0].bulge, 0.01);
}

// A roof that rises to the east, and a wall beside it, which goes the other way.
TEST(Project, KeepsARoofOnItsEdges) {
  Source source = rectangle_of("EPSG:4326", {10, 60}, {10.1, 60.0005});
  source.footprints[0].heights = {10, 30, 30, 10};
  source.footprints[0].top = 30;
  geom::Footprint wall = source.footprints[0];
  wall.polygon.outer = {{10.1, 60}, {10, 60}, {10, 60}, {10.1, 60}};
  wall.heights = {30, 10, 0, 0};
  source.footprints.push_back(wall);
  const Source map = projected(source, 0.5);
  const auto& roof = map.footprints[0];
  ASSERT_EQ(roof.heights.size(), roof.polygon.outer.size());
  const std::size_t bends = roof.polygon.outer.size() / 2 - 2;
  for (std::size_t i = 0; i <= bends + 1; ++i) {
    EXPECT_NEAR(roof.heights[i], 10 + 20.0 * i / (bends + 1), 1e-9);
    EXPECT_EQ(map.footprints[1].polygon.outer[bends + 1 - i], roof.polygon.outer[i]);
  }
}

TEST(Project, EdgesGoTheShortWayAroundTheEarth) {
  const Source map = projected(rectangle_of("EPSG:4326", {179.999, 60}, {-179.999, 60.0005}), 0.5);
  const auto& ring = map.footprints[0].polygon.outer;
  for (const geom::Vec2& p : ring) EXPECT_LT((p - ring[0]).norm(), 130);
}

TEST(Projector, TakesTheMiddleOfWhatLiesAcrossTheAntimeridian) {
  Source both = rectangle_of("EPSG:4326", {179.996, -17}, {180, -16.9996});
  both.footprints.push_back(
      rectangle_of("EPSG:4326", {-180, -17}, {-179.988, -16.9996}).footprints[0]);
  const Projector projector(both, "t.geojson", std::nullopt, false);
  EXPECT_NEAR(projector.frame().origin->longitude, -179.996, 1e-6);
  const Source map = projected(both, 0.5);
  for (const geom::Footprint& f : map.footprints) {
    for (const geom::Vec2& p : f.polygon.outer) EXPECT_LT(p.norm(), 900);
  }
  EXPECT_NO_THROW(Projector(both, "t.geojson", geom::Vec2(-17, 179.9), false));
}

TEST(Projector, RefusesCoordinatesFromTheMiddleOfTheEarth) {
  Source source = rectangle_of("EPSG:4978", {2883000, 1340000}, {2883100, 1340100});
  EXPECT_TRUE(support::says(
      support::refusal_of([&] { Projector(source, "t.gpkg", std::nullopt, false); }),
      "t.gpkg: PROJ knows no way from the reference system"));
}

TEST(CheckSizes, RefusesWhatIsFarFromTheOrigin) {
  const Source far = rectangle_of("EPSG:4326", {-3e6, 0}, {-2.9999e6, 100});  // as projected
  EXPECT_TRUE(support::says(support::refusal_of([&] { check_sizes(far, 0.5, "t.gpkg"); }),
                            "expected a footprint within 2000000 m of the origin"));
  const Source local = rectangle_of("", {-3e6, 0}, {-2.9999e6, 100});
  EXPECT_EQ(support::refusal_of([&] { check_sizes(local, 0.5, "t.gpkg"); }), "");
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

// PROJ offers conversions that take two datums for one, which may be 10 m and more off.
TEST(Projector, RefusesAConversionThatTakesTwoDatumsForOne) {
  for (const char* crs : {"EPSG:2029", "EPSG:4608", "EPSG:4004", "EPSG:2029+5713"}) {
    Source source = grid_of(crs, {0.5, 43}, 1e-4);
    EXPECT_TRUE(
        support::says(support::refusal_of([&] { Projector(source, "t.tif", std::nullopt, false); }),
                      "t.tif: PROJ knows no way from the reference system"))
        << crs;
    EXPECT_TRUE(std::isinf(lean_of(*source.grid, 9, 9, source.crs, std::nullopt).row)) << crs;
  }
}

TEST(Projector, TakesSystemsWhoseDatumsAreTiedToWgs84) {
  for (const char* crs : {"EPSG:25832", "EPSG:28992", "EPSG:7415", "EPSG:31256", "EPSG:27700",
                          "EPSG:2154", "EPSG:2263", "EPSG:26918", "EPSG:6347", "EPSG:5555",
                          "EPSG:25832+5783", "EPSG:2056", "EPSG:6677", "EPSG:7855"}) {
    const auto system = geom::ProjReference::of(crs);
    const auto area = system->area();
    ASSERT_TRUE(area) << crs;
    geom::Vec2 middle(0.5 * (area->west + area->east), 0.5 * (area->south + area->north));
    const auto way = geom::ProjWay::to_places(*system);
    ASSERT_TRUE(way) << crs;
    way->back({&middle, 1});
    Source source = grid_of(crs, middle, 1);
    EXPECT_NO_THROW(Projector(source, "t.tif", std::nullopt, false)) << crs;
  }
}

TEST(Projector, RefusesAPointThatCannotBeConverted) {
  Source source = grid_of("EPSG:32633", {600000, 5340000}, 10);
  const Projector projector(source, "t.tif", std::nullopt, false);
  std::vector<geom::Vec2> points{{600000, 5340000}, {1e30, 1e30}, {600000, 5340000}};
  EXPECT_THROW(projector.convert(points), geom::InputError);
}

// A raster of 20 x 10 cells of 5 m, as high as the middles of its cells are east.
MemoryRasterSpec ramp() {
  return {.columns = 20,
          .rows = 10,
          .cell = [](int column, int) { return 5 * column + 2.5; },
          .transform = {0, 5, 0, 50, 0, -5},
          .epsg = 0};
}

// A house of 10 m on a terrain in the same coordinates.
Source lifted(const MemoryRaster& raster, const Vec2& low, const Vec2& high) {
  Source out;
  geom::Footprint house;
  house.top = 10;
  house.polygon.outer = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  out.footprints = {house};
  lift(out, Terrain(raster.path(), "ramp.tif", {}), {});
  return out;
}

void expect_partly_without_terrain(Source source, const char* what) {
  EXPECT_EQ(source.counts["footprints_partly_without_terrain"], 1u) << what;
  EXPECT_EQ(source.skipped.text(),
            "1 x footprint with unknown ground under a part of it (feature 0)")
      << what;
}

TEST(Lift, StandsOnTheLowestAndReachesAboveTheHighestGround) {
  const MemoryRaster raster(ramp());
  const Source source = lifted(raster, {20, 10}, {90, 30});
  EXPECT_TRUE(source.skipped.empty());
  EXPECT_EQ(source.footprints[0].bottom, 17.5);
  EXPECT_EQ(source.footprints[0].top, 102.5);
}

TEST(Lift, TakesAFootprintAsLargeAsTheTerrain) {
  const MemoryRaster raster(ramp());
  EXPECT_TRUE(lifted(raster, {0, 0}, {100, 50}).skipped.empty());
  EXPECT_TRUE(lifted(raster, {100, 0}, {100, 50}).skipped.empty()) << "a wall along its edge";
}

TEST(Lift, SkipsAFootprintOverGroundThatIsUnknownInPart) {
  const MemoryRaster one_hole(ramp(), [](GDALDataset& made) {
    made.GetRasterBand(1)->SetNoDataValue(52.5);  // column 10
  });
  expect_partly_without_terrain(lifted(one_hole, {20, 10}, {90, 30}), "a hole in its middle");
  expect_partly_without_terrain(lifted(one_hole, {20, 10}, {50.5, 30}), "a hole below its side");
  EXPECT_TRUE(lifted(one_hole, {20, 10}, {50, 30}).skipped.empty()) << "a hole beside it";
  EXPECT_TRUE(lifted(one_hole, {50, 10}, {50, 30}).skipped.empty()) << "a wall beside it";
  expect_partly_without_terrain(lifted(one_hole, {52, 10}, {52, 30}), "a wall in it");
}

TEST(Lift, SkipsAFootprintThatReachesBeyondTheTerrain) {
  const MemoryRaster raster(ramp());
  expect_partly_without_terrain(lifted(raster, {90, 10}, {101, 30}), "east");
  expect_partly_without_terrain(lifted(raster, {-1, 10}, {10, 30}), "west");
  expect_partly_without_terrain(lifted(raster, {90, 40}, {95, 51}), "north");
  expect_partly_without_terrain(lifted(raster, {90, -1}, {95, 10}), "south");
  const Source nowhere = lifted(raster, {200, 10}, {210, 30});
  EXPECT_EQ(nowhere.skipped.text(), "1 x footprint without ground under it (feature 0)");
  EXPECT_TRUE(nowhere.footprints.empty()) << "it would stand at 0";
}

TEST(Lift, RefusesATerrainWhoseDatumIsNotTied) {
  MemoryRasterSpec spec = ramp();
  spec.epsg = 2029;
  const MemoryRaster raster(spec);
  Source out;
  out.footprints.resize(1);
  out.footprints[0].polygon.outer = {{0, 0}, {1, 0}, {1, 1}};
  EXPECT_TRUE(support::says(
      support::refusal_of([&] {
        const geom::GeodeticOrigin origin{48, 15, 0};
        lift(out, Terrain(raster.path(), "ramp.tif", {}),
             {.origin = origin, .crs = geom::plane_about(origin)});
      }),
      "ramp.tif: PROJ knows no way from the reference system \"NAD27(76)"));
}

}  // namespace
}  // namespace geom::gis
