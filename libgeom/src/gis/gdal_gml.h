#pragma once

// GML as GDAL is given it (gdal_*.cpp only).

#include <memory>
#include <string>

#include "gdal_handles.h"

namespace geom::gis {

// A GML file in memory. Beside a file on a disk GDAL looks for a .gfs and an .xsd, which may be of
// another time and hide features or cut numbers, and it leaves a .gfs there.
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

}  // namespace geom::gis
