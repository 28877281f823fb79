#pragma once

// Files in memory that GDAL reads, for tests.

#include <gdal_priv.h>

#include <string>

#include "geom/gis/footprint_source.h"

namespace geom::gis {

// Exists as long as this does.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& name, const std::string& text = "")
      : path_("/vsimem/" + name) {
    if (!text.empty()) write(text);
  }
  ~MemoryFile() { VSIUnlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

  void write(const std::string& text) const {
    VSILFILE* const file = VSIFOpenL(path_.c_str(), "wb");
    VSIFWriteL(text.data(), 1, text.size(), file);
    VSIFCloseL(file);
  }
  std::string read() const {
    vsi_l_offset size = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return {reinterpret_cast<const char*>(bytes), bytes ? static_cast<std::size_t>(size) : 0};
  }

 private:
  std::string path_;
};

// Text of GeoJSON, or of any other format that GDAL knows by the end of its name.
inline Source read_text(const std::string& name, const std::string& text,
                        const ReadOptions& options) {
  const MemoryFile file(name, text);
  return read_vector(file.path(), name, options);
}

inline Source read_geojson(const std::string& text, const ReadOptions& options) {
  return read_text("city.geojson", text, options);
}

}  // namespace geom::gis
