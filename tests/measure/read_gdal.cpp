// read_gdal FILE: reads all heights of a raster, or all features of a vector file, by GDAL alone,
// and says how many cells or corners there were: the peer of skyway-footprints in source_growth.py.

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <iostream>
#include <vector>

namespace {

std::size_t cells_of(GDALDataset& dataset) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  const int width = dataset.GetRasterXSize();
  std::vector<double> row(static_cast<std::size_t>(width));
  std::size_t cells = 0;
  for (int i = 0; i < dataset.GetRasterYSize(); ++i) {
    const CPLErr error =
        band.RasterIO(GF_Read, 0, i, width, 1, row.data(), width, 1, GDT_Float64, 0, 0);
    if (error != CE_None) return 0;
    cells += row.size();
  }
  return cells;
}

std::size_t corners_of(const OGRGeometry& geometry) {
  if (const auto* polygon = dynamic_cast<const OGRPolygon*>(&geometry)) {
    std::size_t corners = 0;
    for (const OGRLinearRing* ring : *polygon) {
      corners += static_cast<std::size_t>(ring->getNumPoints());
    }
    return corners;
  }
  std::size_t corners = 0;
  if (const auto* parts = dynamic_cast<const OGRGeometryCollection*>(&geometry)) {
    for (const OGRGeometry* part : *parts) corners += corners_of(*part);
  }
  return corners;
}

std::size_t corners_of(GDALDataset& dataset) {
  std::size_t corners = 0;
  OGRLayer* layer = nullptr;
  // As OpenStreetMap files want it: features come in the file's order, of any layer.
  while (OGRFeature* feature = dataset.GetNextFeature(&layer, nullptr, nullptr, nullptr)) {
    if (const OGRGeometry* geometry = feature->GetGeometryRef()) corners += corners_of(*geometry);
    OGRFeature::DestroyFeature(feature);
  }
  return corners;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  GDALAllRegister();
  auto* dataset = static_cast<GDALDataset*>(
      GDALOpenEx(argv[1], GDAL_OF_RASTER | GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  if (!dataset) return 3;
  const bool raster = dataset->GetRasterCount() > 0;
  std::cout << (raster ? cells_of(*dataset) : corners_of(*dataset)) << '\n';
  GDALClose(dataset);
  return 0;
}
