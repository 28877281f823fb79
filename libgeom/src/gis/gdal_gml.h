#pragma once

// GML as GDAL is given it (gdal_*.cpp only).

#include <memory>
#include <string>

#include "gdal_handles.h"
#include "gml_told.h"

namespace geom::gis {

// A GML file in memory. Beside a file on a disk GDAL looks for a .gfs and an .xsd, which may be of
// another time and hide features or cut numbers, and it leaves a .gfs there. As long as this
// exists, rings that are not closed are none for this thread: such are lists of numbers in threes
// that do not say so, which GDAL reads in pairs.
class GmlInMemory {
 public:
  // Null for a file that is no GML. It may be packed (gzip). Throws InputError(name, …) where it
  // cannot be read.
  static std::unique_ptr<GmlInMemory> of(const std::string& path, const std::string& name);
  ~GmlInMemory();
  GmlInMemory(const GmlInMemory&) = delete;
  GmlInMemory& operator=(const GmlInMemory&) = delete;

  const std::string& path() const { return path_; }  // as long as this exists
  const std::string& text() const { return text_; }

 private:
  explicit GmlInMemory(std::string text);

  std::string text_;
  std::string path_;
};

// Throws InputError(name, …) where all features of the dataset together have fewer geometries, or
// polygons in them, than the text: GDAL takes one geometry of a feature, and one polygon where the
// standard has one. Also for arcs about a centre that are not in metres both: GDAL takes the number
// of a radius in the unit of the coordinates, and in degrees takes east for north.
void require_whole_gml(const DatasetHandle& dataset, const GmlTold& told, const std::string& name);

}  // namespace geom::gis
