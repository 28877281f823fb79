#pragma once

// What a mosaic of GDAL (.vrt) says of the rasters that it is made of.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geom::gis {

// Columns and rows.
struct VrtRectangle {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

// A part of a mosaic's band of numbers.
struct VrtSource {
  int band_of_mosaic = 1;  // from 1
  std::string file;
  bool beside = false;               // the file's name counts from the mosaic's folder
  int band = 1;                      // of the file
  std::optional<double> none;        // cells of the file with this value are left out
  bool obeys_mask = false;           // so are cells that its mask excludes
  std::optional<VrtRectangle> from;  // of the file; absent: all
  std::optional<VrtRectangle> to;    // of the mosaic; absent: all
};

// The sources of bands, without those of masks and overviews. Throws InputError(name, …) for text
// that is no XML.
std::vector<VrtSource> vrt_sources(std::string_view text, const std::string& name);

}  // namespace geom::gis
