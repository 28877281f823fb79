#include "gis/gdal_whole_raster.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/gis/footprint_source.h"
#include "geom/gis/people_raster.h"
#include "geom/gis/read_footprints.h"
#include "support/memory_raster.h"
#include "support/reading.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

std::string raster_refusal(const std::string& path) {
  return refusal_of([&] { read_raster(path, "r", {}); });
}

// A second picture of the file that the raster is in.
void add_page(const std::string& path) {
  char append[] = "APPEND_SUBDATASET=YES";
  char* options[] = {append, nullptr};
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALClose(driver.Create(path.c_str(), 4, 4, 1, GDT_Float32, options));
}

TEST(RequireWholeRaster, RefusesAFileOfSeveralPictures) {
  const MemoryRaster raster({});
  EXPECT_EQ(raster_refusal(raster.path()), "");
  add_page(raster.path());
  EXPECT_TRUE(says(raster_refusal(raster.path()), "r: expected one raster in the file, found 2"));
  EXPECT_TRUE(says(refusal_of([&] { Terrain(raster.path(), "r", {}); }), "found 2"));
  EXPECT_TRUE(says(refusal_of([&] {
                     people_within(raster.path(), {49.6, 8.9}, {49.7, 9.1});
                   }),
                   "found 2"));
}

TEST(RequireWholeRaster, TakesOverviewsForNoPictures) {
  const MemoryRaster raster({.columns = 64, .rows = 64});
  GDALDataset* const made = GDALDataset::Open(raster.path().c_str(), GDAL_OF_UPDATE);
  const int levels[] = {2};
  made->BuildOverviews("NEAREST", 1, levels, 0, nullptr, nullptr, nullptr);
  GDALClose(made);
  EXPECT_EQ(raster_refusal(raster.path()), "");
}

// A mosaic of 8 x 4 cells, of which the raster covers `columns`.
std::string mosaic(const MemoryRaster& raster, int columns, const std::string& more) {
  return fmt::format(
      "<VRTDataset rasterXSize=\"8\" rasterYSize=\"4\"><GeoTransform>500000, 5, 0, 5500020, 0, -5"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">{2}<SimpleSource>"
      "<SourceFilename>{0}</SourceFilename><SourceBand>1</SourceBand>"
      "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"4\" ySize=\"4\"/>"
      "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"{1}\" ySize=\"4\"/>"
      "</SimpleSource></VRTRasterBand></VRTDataset>",
      raster.path(), columns, more);
}

// GDAL gives 0 there.
TEST(RequireWholeRaster, RefusesAMosaicWithGaps) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }});
  const MemoryFile gaps("gaps.vrt", mosaic(raster, 4, ""));
  EXPECT_TRUE(says(raster_refusal(gaps.path()), "found none, in a mosaic with gaps"));
  const MemoryFile whole("whole.vrt", mosaic(raster, 8, ""));
  EXPECT_EQ(raster_refusal(whole.path()), "");
  const MemoryFile known("known.vrt", mosaic(raster, 4, "<NoDataValue>-9999</NoDataValue>"));
  Source source = read_raster(known.path(), "r", {});
  EXPECT_EQ(source.counts["cells_without_data"], 16u);
}

// GDAL gives 0 for the point that is not there.
TEST(RequireWholeRaster, RefusesATableOfPoints) {
  const MemoryFile points("points.xyz", "0 0 5\n5 0 5\n10 0 5\n0 5 5\n10 5 5\n0 10 5\n5 10 5\n");
  EXPECT_TRUE(says(raster_refusal(points.path()), "may not keep numbers or holes (XYZ)"));
}

TEST(RequireWholeRaster, RefusesColoursOfAPalette) {
  const MemoryRaster raster(
      {},
      [](GDALDataset& made) { made.GetRasterBand(1)->SetColorInterpretation(GCI_PaletteIndex); },
      "palette.tif");
  EXPECT_TRUE(says(raster_refusal(raster.path()), "expected numbers, found a picture"));
}

// GDAL takes 0 for a word, and passes over what follows.
TEST(RequireWholeRaster, LooksAtEachWordOfAnAsciiGrid) {
  const std::string head = "ncols 2\nNROWS 2\nxllcorner 0,5\nyllcorner 0\ncellsize 5\n";
  const auto said = [&](const std::string& cells) {
    const MemoryFile grid("grid.asc", head + cells);
    return raster_refusal(grid.path());
  };
  for (const char* cells :
       {"1 2\n3 4\n", "1 2 3 4", "\r\n1\t2,5\r\n-3e1 nan\r\n", "NODATA_value -9999\n1 2 3 4"}) {
    EXPECT_EQ(said(cells), "") << cells;
  }
  EXPECT_TRUE(says(said("1 2\n3 tall\n"), "expected 4 numbers behind its head, found \"tall\""));
  EXPECT_TRUE(says(said("1 2\n3 4\n5 6\n"), "expected 4 numbers behind its head, found more"));
  EXPECT_TRUE(says(said("1 2\n3\n"), "expected 4 numbers behind its head, found 3 numbers"));
}

TEST(FootprintFormatOf, RefusesARasterBesidePolygons) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "both.gpkg";
  GDALAllRegister();
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GPKG");
  GDALDataset* made = driver.Create(path.c_str(), 4, 4, 1, GDT_Float32, nullptr);
  double transform[] = {500000, 5, 0, 5500020, 0, -5};
  OGRSpatialReference reference;
  reference.importFromEPSG(32632);
  made->SetSpatialRef(&reference);
  made->SetGeoTransform(transform);
  MemoryRaster::fill(*made->GetRasterBand(1), [](int, int) { return 7; });
  GDALClose(made);
  EXPECT_EQ(&footprint_format_of("SQLite format 3", path), &kRaster);
  made = GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE);
  made->CreateLayer("houses", &reference, wkbPolygon);
  GDALClose(made);
  EXPECT_TRUE(says(refusal_of([&] { footprint_format_of("SQLite format 3", path); }),
                   "expected a raster of heights, or polygons, found both in one file"));
}

}  // namespace
}  // namespace geom::gis
