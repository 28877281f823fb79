#pragma once

// A shapefile in memory, for tests.

#include <ogrsf_frmts.h>

#include <string>
#include <vector>

#include "support/memory_file.h"

namespace geom::gis {

struct Prism {
  std::vector<geom::Vec2> corners;
  std::vector<double> levels;  // of the corners
  double height = 0;
};

// The three files that shapes need.
struct ShapeFiles {
  MemoryFile shp{"city.shp"};
  MemoryFile shx{"city.shx"};
  MemoryFile dbf{"city.dbf"};
};

inline void write_layer(const char* driver, const std::string& path,
                        const std::vector<Prism>& prisms) {
  GDALAllRegister();
  GDALDataset* const dataset = GetGDALDriverManager()->GetDriverByName(driver)->Create(
      path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  OGRLayer* const layer = dataset->CreateLayer("city", nullptr, wkbPolygon25D, nullptr);
  OGRFieldDefn field("height", OFTReal);
  layer->CreateField(&field);
  for (const Prism& prism : prisms) {
    OGRLinearRing ring;
    for (std::size_t i = 0; i <= prism.corners.size(); ++i) {
      const std::size_t k = i % prism.corners.size();
      ring.addPoint(prism.corners[k].x(), prism.corners[k].y(), prism.levels[k]);
    }
    OGRPolygon polygon;
    polygon.addRing(&ring);
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetGeometry(&polygon);
    feature.SetField("height", prism.height);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) throw std::runtime_error("not written");
  }
  GDALClose(dataset);
}

}  // namespace geom::gis
