#include "gis/gdal_cells.h"

#include <gtest/gtest.h>

#include "geom/gis/footprint_source.h"
#include "geom/gis/people_raster.h"
#include "support/memory_raster.h"
#include "support/reading.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

// Of a raster of 4 x 4 cells, that of column 1 and row 2 has no number.
bool is_hole(int column, int row) { return column == 1 && row == 2; }

void mask_hole(GDALDataset& made, int flags) {
  ASSERT_EQ(made.CreateMaskBand(flags), CE_None);
  MemoryRaster::fill(*made.GetRasterBand(1)->GetMaskBand(),
                     [](int column, int row) { return is_hole(column, row) ? 0 : 255; });
}

void mask_inside(GDALDataset& made) {
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
  mask_hole(made, GMF_PER_DATASET);
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
}

void mask_beside(GDALDataset& made) {
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "NO");
  mask_hole(made, GMF_PER_DATASET);
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
}

// The second band says how opaque cells are: the hole is nearly so.
void make_hole_transparent(GDALDataset& made) {
  GDALRasterBand& opacity = *made.GetRasterBand(2);
  opacity.SetColorInterpretation(GCI_AlphaBand);
  MemoryRaster::fill(opacity, [](int column, int row) { return is_hole(column, row) ? 254 : 255; });
}

void make_hole_transparent_with_none(GDALDataset& made) {
  make_hole_transparent(made);
  made.GetRasterBand(1)->SetNoDataValue(-1);
}

struct Case {
  std::string name;
  int bands;
  std::function<void(GDALDataset&)> finish;
};

std::vector<Case> cases() {
  return {{"a mask in the file", 1, mask_inside},
          {"a mask beside it", 1, mask_beside},
          {"a band of opacity", 2, make_hole_transparent},
          {"a band of opacity and a value for none", 2, make_hole_transparent_with_none}};
}

TEST(RasterCells, MaskedHeightsAreHoles) {
  for (const Case& one : cases()) {
    const MemoryRaster raster({.bands = one.bands}, one.finish);
    Source source = read_raster(raster.path(), "r.tif", {});
    EXPECT_EQ(source.counts["cells"], 15u) << one.name;
    EXPECT_EQ(source.counts["cells_without_data"], 1u) << one.name;
  }
}

TEST(RasterCells, MaskedGroundIsUnknown) {
  for (const Case& one : cases()) {
    const MemoryRaster raster({.bands = one.bands}, one.finish);
    const Terrain terrain(raster.path(), "r.tif", {});
    const Vec2 known[] = {{500001, 5500019}};
    EXPECT_TRUE(terrain.surface(known)) << one.name;
    const Vec2 hole[] = {{500007.5, 5500007.5}};
    EXPECT_FALSE(terrain.surface(hole)) << one.name;
  }
}

TEST(RasterCells, MaskedPeopleAreUnknown) {
  for (const Case& one : cases()) {
    const MemoryRaster raster({.bands = one.bands}, one.finish);
    const std::vector<PeopleCell> cells = people_within(raster.path(), {49.6, 8.9}, {49.7, 9.1});
    ASSERT_EQ(cells.size(), 16u) << one.name;
    for (const PeopleCell& cell : cells) {
      const bool hole = is_hole(static_cast<int>(cell.column), static_cast<int>(cell.row));
      EXPECT_EQ(cell.people.has_value(), !hole) << one.name;
    }
  }
}

TEST(RasterCells, RefusesAMaskThatIsPassedOver) {
  const MemoryRaster raster({});
  const MemoryFile mask("raster.tif.msk", "no mask");
  EXPECT_TRUE(says(refusal_of([&] { read_raster(raster.path(), "r.tif", {}); }),
                   "r.tif: expected a mask beside it that GDAL can read"));
}

TEST(RasterCells, NumbersHaveTheScaleOfTheirBand) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }}, [](GDALDataset& made) {
    made.GetRasterBand(1)->SetScale(2);
    made.GetRasterBand(1)->SetOffset(1);
  });
  const Terrain terrain(raster.path(), "r.tif", {});
  const Vec2 middle[] = {{500010, 5500010}};
  EXPECT_EQ(terrain.surface(middle)->high, 15);
}

TEST(RasterCells, RefusesAScaleThatMakesAllNumbersOne) {
  for (const double scale : {0.0, std::nan("")}) {
    const MemoryRaster raster({},
                              [&](GDALDataset& made) { made.GetRasterBand(1)->SetScale(scale); });
    EXPECT_TRUE(says(refusal_of([&] { Terrain(raster.path(), "r.tif", {}); }),
                     "r.tif: expected a finite scale that is not 0"));
  }
}

// Esri's format says so.
TEST(RasterCells, AnAsciiGridThatNamesNoValueForNoneHasOne) {
  const std::string cells = "-9999 1\n2 3\n";
  const std::string head = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n";
  const MemoryFile silent("silent.asc", head + cells);
  Source source = read_raster(silent.path(), "silent.asc", {});
  EXPECT_EQ(source.counts["cells_without_data"], 1u);
  EXPECT_EQ(source.counts["cells"], 3u);
  const MemoryFile says_another("another.asc", head + "NODATA_value 2\n" + cells);
  EXPECT_TRUE(says(refusal_of([&] { read_raster(says_another.path(), "another.asc", {}); }),
                   "another.asc: row 0, column 0: expected a height, found -9999"));
}

// As a height it would put houses on a terrain 10 km below the others.
TEST(ReadRaster, RefusesTheUsualValueForNoneWhereNothingSaysSo) {
  const auto cell = [](int column, int row) { return is_hole(column, row) ? -9999.0 : 7.0; };
  const MemoryRaster silent({.cell = cell});
  for (const auto& read : {std::function([&] { read_raster(silent.path(), "r.tif", {}); }),
                           std::function([&] { Terrain(silent.path(), "r.tif", {}); })}) {
    EXPECT_TRUE(says(refusal_of(read), "r.tif: row 2, column 1: expected a height, found -9999"));
  }
  const MemoryRaster said({.cell = cell},
                          [](GDALDataset& made) { made.GetRasterBand(1)->SetNoDataValue(-9999); });
  EXPECT_EQ(read_raster(said.path(), "r.tif", {}).counts.at("cells_without_data"), 1u);
  const MemoryRaster other(
      {.cell = cell}, [](GDALDataset& made) { made.GetRasterBand(1)->SetNoDataValue(-32768); });
  EXPECT_TRUE(says(refusal_of([&] { read_raster(other.path(), "r.tif", {}); }),
                   "r.tif: row 2, column 1: expected a height, found -9999"));
}

// GDAL passes over it.
TEST(ReadRaster, RefusesFeetThatOnlyThePrjTells) {
  const MemoryFile grid("feet.asc",
                        "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n10 20\n30 40\n");
  const auto prj = [](const std::string& unit) {
    return "Projection UTM\nZone 32\nDatum WGS84\nZunits " + unit + "\nUnits METERS\n";
  };
  const MemoryFile metres("feet.prj", prj("METERS"));
  EXPECT_EQ(refusal_of([&] { read_raster(grid.path(), "r.asc", {}); }), "");
  metres.write(prj("FEET"));
  EXPECT_TRUE(says(refusal_of([&] { read_raster(grid.path(), "r.asc", {}); }),
                   "r.asc: expected heights in metres, found \"Zunits FEET\" in its .prj"));
  ReadOptions options;
  options.height_unit = 0.3048;
  options.height_step = 0;
  EXPECT_DOUBLE_EQ(read_raster(grid.path(), "r.asc", options).footprints.front().bottom, 3.048);
}

TEST(ReadRaster, KnowsUnitsInCapitalsAndSmallLetters) {
  for (const char* unit : {"Feet", "FEET", "foot"}) {
    const MemoryRaster raster({.cell = [](int, int) { return 10.0; }},
                              [&](GDALDataset& made) { made.GetRasterBand(1)->SetUnitType(unit); });
    ReadOptions options;
    options.height_step = 0;
    EXPECT_DOUBLE_EQ(read_raster(raster.path(), "r.tif", options).footprints.front().top, 3.048)
        << unit;
  }
}

TEST(ReadRaster, RefusesDepths) {
  const MemoryRaster raster({}, [](GDALDataset& made) {
    OGRSpatialReference depths;
    depths.SetFromUserInput("EPSG:32632+5715");
    made.SetSpatialRef(&depths);
  });
  for (const std::optional<double> unit : {std::optional<double>(), std::optional<double>(1)}) {
    ReadOptions options;
    options.height_unit = unit;
    EXPECT_TRUE(says(refusal_of([&] { read_raster(raster.path(), "r.tif", options); }),
                     "r.tif: expected heights that count upwards, found depths"));
  }
}

TEST(NumberBands, AreAllButOpacity) {
  const MemoryRaster raster({.bands = 3}, [](GDALDataset& made) {
    made.GetRasterBand(3)->SetColorInterpretation(GCI_AlphaBand);
  });
  const std::string refusal = refusal_of([&] { read_raster(raster.path(), "r.tif", {}); });
  EXPECT_TRUE(says(refusal, "expected one band of heights, found 2"));
  EXPECT_TRUE(says(refusal, "-b 1 -mask 3"));
}

}  // namespace
}  // namespace geom::gis
