#include "gis/gdal_whole_raster.h"

#include <fmt/format.h>
#include <gdal_utils.h>
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

// A mosaic of 8 x 4 cells, of which the raster at `path` covers `columns`.
std::string mosaic(const std::string& path, int columns, const std::string& more) {
  return fmt::format(
      "<VRTDataset rasterXSize=\"8\" rasterYSize=\"4\"><GeoTransform>500000, 5, 0, 5500020, 0, -5"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">{2}<SimpleSource>"
      "<SourceFilename>{0}</SourceFilename><SourceBand>1</SourceBand>"
      "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"4\" ySize=\"4\"/>"
      "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"{1}\" ySize=\"4\"/>"
      "</SimpleSource></VRTRasterBand></VRTDataset>",
      path, columns, more);
}

// GDAL gives 0 there.
TEST(RequireWholeRaster, RefusesAMosaicWithGaps) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }});
  const MemoryFile gaps("gaps.vrt", mosaic(raster.path(), 4, ""));
  EXPECT_TRUE(says(raster_refusal(gaps.path()), "found none, in a mosaic with gaps"));
  const MemoryFile whole("whole.vrt", mosaic(raster.path(), 8, ""));
  EXPECT_EQ(raster_refusal(whole.path()), "");
  const MemoryFile known("known.vrt", mosaic(raster.path(), 4, "<NoDataValue>-9999</NoDataValue>"));
  Source source = read_raster(known.path(), "r", {});
  EXPECT_EQ(source.counts["cells_without_data"], 16u);
}

// The outer mosaic's value for none does not reach the gaps of the inner one.
TEST(RequireWholeRaster, RefusesAMosaicOfOneWithGaps) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }});
  const MemoryFile gaps("gaps.vrt", mosaic(raster.path(), 4, ""));
  for (const char* none : {"", "<NoDataValue>-9999</NoDataValue>"}) {
    const MemoryFile outer("outer.vrt", mosaic(gaps.path(), 8, none));
    EXPECT_TRUE(says(raster_refusal(outer.path()), "found none, in a mosaic with gaps"));
  }
  const MemoryFile inner("inner.vrt", mosaic(raster.path(), 8, ""));
  const MemoryFile whole("whole.vrt", mosaic(inner.path(), 8, ""));
  EXPECT_EQ(raster_refusal(whole.path()), "");
}

// A mosaic of 4 x 4 cells of the raster at `path`: the head of its band, and its source.
std::string plain_mosaic(const std::string& path, const std::string& type, const std::string& more,
                         const std::string& source, const std::string& in_source) {
  return fmt::format(
      "<VRTDataset rasterXSize=\"4\" rasterYSize=\"4\"><GeoTransform>500000, 5, 0, 5500020, 0, -5"
      "</GeoTransform><VRTRasterBand dataType=\"{1}\" band=\"1\">{2}<{3}><SourceFilename>{0}"
      "</SourceFilename><SourceBand>1</SourceBand>{4}</{3}></VRTRasterBand></VRTDataset>",
      path, type, more, source, in_source);
}

TEST(RequireWholeRaster, RefusesAMosaicThatGivesHolesNumbers) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }},
                            [](GDALDataset& made) { made.GetRasterBand(1)->SetNoDataValue(-50); });
  const auto refusal = [&](const std::string& more, const std::string& source,
                           const std::string& in_source) {
    const MemoryFile file("m.vrt", plain_mosaic(raster.path(), "Float32", more, source, in_source));
    return raster_refusal(file.path());
  };
  const std::string none = "<NoDataValue>-9999</NoDataValue>";
  EXPECT_TRUE(says(refusal("", "SimpleSource", ""), "cells without a number have none"));
  EXPECT_TRUE(says(refusal("", "ComplexSource", "<NODATA>-50</NODATA>"), "have none"));
  EXPECT_TRUE(says(refusal(none, "SimpleSource", ""), "have none"));
  EXPECT_TRUE(says(refusal(none, "ComplexSource", "<NODATA>0</NODATA>"), "have none"));
  EXPECT_EQ(refusal(none, "ComplexSource", "<NODATA>-50</NODATA>"), "");
  EXPECT_EQ(refusal("<NoDataValue>-50</NoDataValue>", "SimpleSource", ""), "");
}

TEST(RequireWholeRaster, RefusesAMosaicOfNarrowerNumbersOrLargerCells) {
  const MemoryRaster raster({.cell = [](int, int) { return 300.5; }});
  const auto refusal = [&](const std::string& type, const std::string& in_source) {
    const MemoryFile file("m.vrt",
                          plain_mosaic(raster.path(), type, "", "SimpleSource", in_source));
    return raster_refusal(file.path());
  };
  EXPECT_EQ(refusal("Float64", ""), "");
  EXPECT_TRUE(says(refusal("Byte", ""), "a narrower one"));
  EXPECT_TRUE(says(refusal("Int32", ""), "a narrower one"));
  const MemoryRaster fine({.columns = 8, .rows = 8, .cell = [](int, int) { return 3.0; }});
  const MemoryFile coarse(
      "m.vrt",
      plain_mosaic(fine.path(), "Float32", "", "SimpleSource",
                   "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"8\" ySize=\"8\"/><DstRect xOff=\"0\" "
                   "yOff=\"0\" xSize=\"4\" ySize=\"4\"/>"));
  EXPECT_TRUE(says(raster_refusal(coarse.path()), "larger ones, of which GDAL leaves out"));
}

TEST(RequireWholeRaster, RefusesNumbersThatAPicturesCompressionChanges) {
  GDALAllRegister();
  const MemoryFile file("jpeg.tif", "");
  char option[] = "COMPRESS=JPEG";
  char* options[] = {option, nullptr};
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDataset* const made = driver.Create(file.path().c_str(), 16, 16, 1, GDT_Byte, options);
  double transform[] = {500000, 5, 0, 5500020, 0, -5};
  made->SetGeoTransform(transform);
  MemoryRaster::fill(*made->GetRasterBand(1), [](int, int) { return 7; });
  GDALClose(made);
  EXPECT_TRUE(says(raster_refusal(file.path()), "found COMPRESSION=JPEG"));
}

// What a warped mosaic covers, GDAL does not tell.
TEST(RequireWholeRaster, RefusesAWarpedMosaicWithoutAValueForNone) {
  const MemoryRaster raster({.cell = [](int, int) { return 7.0; }});
  const auto warped = [&](std::vector<const char*> options) {
    options.insert(options.begin(), {"-of", "VRT", "-t_srs", "EPSG:4326"});
    options.push_back(nullptr);
    const MemoryFile out("warped.vrt", "");
    GDALWarpAppOptions* const asked =
        GDALWarpAppOptionsNew(const_cast<char**>(options.data()), nullptr);
    GDALDatasetH from = GDALOpen(raster.path().c_str(), GA_ReadOnly);
    GDALClose(GDALWarp(out.path().c_str(), nullptr, 1, &from, asked, nullptr));
    GDALWarpAppOptionsFree(asked);
    GDALClose(from);
    return raster_refusal(out.path());
  };
  EXPECT_TRUE(says(warped({}), "found none, in a mosaic that is turned or warped"));
  EXPECT_EQ(warped({"-dstnodata", "-9999"}), "");
  EXPECT_EQ(warped({"-dstalpha"}), "");
}

// What an interrupted copy leaves: GDAL gives 0 for the rows that were never written.
TEST(RequireWholeRaster, RefusesATiffWithoutSomeOfItsRows) {
  GDALAllRegister();
  const auto sparse = [](double none) {
    const MemoryFile file("sparse.tif", "");
    char option[] = "SPARSE_OK=TRUE";
    char rows[] = "BLOCKYSIZE=4";
    char* options[] = {option, rows, nullptr};
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDataset* const made = driver.Create(file.path().c_str(), 4, 8, 1, GDT_Float32, options);
    double transform[] = {500000, 5, 0, 5500020, 0, -5};
    made->SetGeoTransform(transform);
    if (none != 0) made->GetRasterBand(1)->SetNoDataValue(none);
    std::vector<float> upper(16, 7.0F);
    EXPECT_EQ(made->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 4, upper.data(), 4, 4,
                                               GDT_Float32, 0, 0, nullptr),
              CE_None);
    GDALClose(made);
    return raster_refusal(file.path());
  };
  EXPECT_TRUE(says(sparse(0), "found none, in a TIFF without some of its parts"));
  EXPECT_EQ(sparse(-9999), "");
}

// Of two strips of 4 rows, `heights` and `mask` say which are written, with 7 and with 255.
std::string refusal_of_masked(bool heights, bool mask) {
  GDALAllRegister();
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
  const MemoryFile file("masked.tif", "");
  char option[] = "SPARSE_OK=TRUE";
  char size[] = "BLOCKYSIZE=4";
  char* options[] = {option, size, nullptr};
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDataset* const made = driver.Create(file.path().c_str(), 4, 8, 1, GDT_Float32, options);
  double transform[] = {500000, 5, 0, 5500020, 0, -5};
  made->SetGeoTransform(transform);
  made->CreateMaskBand(GMF_PER_DATASET);
  const auto write = [](GDALRasterBand& band, double value, bool all) {
    const int rows = all ? 8 : 4;
    std::vector<double> numbers(32, value);
    EXPECT_EQ(
        band.RasterIO(GF_Write, 0, 0, 4, rows, numbers.data(), 4, rows, GDT_Float64, 0, 0, nullptr),
        CE_None);
  };
  write(*made->GetRasterBand(1), 7, heights);
  write(*made->GetRasterBand(1)->GetMaskBand(), 255, mask);
  GDALClose(made);
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
  return raster_refusal(file.path());
}

TEST(RequireWholeRaster, RefusesPartsThatAreMissingAndNotMasked) {
  EXPECT_EQ(refusal_of_masked(true, true), "");
  EXPECT_EQ(refusal_of_masked(false, false), "");
  EXPECT_EQ(refusal_of_masked(true, false), "");
  EXPECT_TRUE(says(refusal_of_masked(false, true),
                   "a TIFF without some of its parts, which its mask does not exclude"));
}

// GDAL gives 0 for parts of an Erdas image that were never written.
TEST(RequireWholeRaster, RefusesAnErdasImageWithoutSomeOfItsParts) {
  GDALAllRegister();
  const auto refusal = [](int rows, bool none) {
    const MemoryFile file("part.img", "");
    char option[] = "COMPRESSED=YES";
    char* options[] = {option, nullptr};
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("HFA");
    GDALDataset* const made = driver.Create(file.path().c_str(), 64, 128, 1, GDT_Float32, options);
    double transform[] = {500000, 5, 0, 5500020, 0, -5};
    made->SetGeoTransform(transform);
    if (none) made->GetRasterBand(1)->SetNoDataValue(-9999);
    std::vector<double> numbers(64 * 128, 7.0);
    EXPECT_EQ(made->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 64, rows, numbers.data(), 64, rows,
                                               GDT_Float64, 0, 0, nullptr),
              CE_None);
    GDALClose(made);
    return raster_refusal(file.path());
  };
  EXPECT_EQ(refusal(128, false), "");
  EXPECT_TRUE(says(refusal(64, false), "an Erdas image with a part of 0 alone"));
  EXPECT_EQ(refusal(64, true), "");
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
