#pragma once

// Rasters in memory that GDAL reads, for tests.

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "support/memory_file.h"

namespace geom::gis {

struct MemoryRasterSpec {
  int columns = 4;
  int rows = 4;
  std::function<double(int column, int row)> cell = [](int, int) { return 0.0; };
  std::vector<double> transform = {500000, 5, 0, 5500020, 0, -5};
  int epsg = 32632;  // 0: none
  int bands = 1;     // each with the same cells
};

// A GeoTIFF of numbers of 32 bits. `finish` may change it before it is closed.
class MemoryRaster {
 public:
  explicit MemoryRaster(
      const MemoryRasterSpec& spec,
      const std::function<void(GDALDataset&)>& finish = [](GDALDataset&) {},
      const std::string& name = "raster.tif")
      : file_(name) {
    GDALAllRegister();
    GDALDataset* const made = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path().c_str(), spec.columns, spec.rows, spec.bands, GDT_Float32, nullptr);
    std::vector<double> transform = spec.transform;
    made->SetGeoTransform(transform.data());
    OGRSpatialReference reference;
    if (spec.epsg > 0) {
      reference.importFromEPSG(spec.epsg);
      made->SetSpatialRef(&reference);
    }
    for (int band = 1; band <= spec.bands; ++band) {
      fill(*made->GetRasterBand(band), spec.cell);
    }
    finish(*made);
    GDALClose(made);
  }
  ~MemoryRaster() { VSIUnlink((path() + ".msk").c_str()); }

  const std::string& path() const { return file_.path(); }

  static void fill(GDALRasterBand& band, const std::function<double(int column, int row)>& cell) {
    std::vector<double> cells;
    for (int row = 0; row < band.GetYSize(); ++row) {
      for (int column = 0; column < band.GetXSize(); ++column) {
        cells.push_back(cell(column, row));
      }
    }
    ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, band.GetXSize(), band.GetYSize(), cells.data(),
                            band.GetXSize(), band.GetYSize(), GDT_Float64, 0, 0, nullptr),
              CE_None);
  }

 private:
  MemoryFile file_;
};

}  // namespace geom::gis
