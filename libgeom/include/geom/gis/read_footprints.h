#pragma once

// Reads footprints in any of the formats.
//
// Example:
//   std::ifstream file("blocks.geojson");
//   const std::string path = "blocks.geojson";
//   const geom::gis::FootprintFormat& format =
//       geom::gis::footprint_format_of("{\"type\":\"FeatureCollection\"", path);
//   const geom::gis::Source source = geom::gis::read(format, {path, path, file}, {});
//   assert(!source.footprints.empty());

#include <istream>
#include <string>
#include <string_view>

#include "geom/gis/footprint_format.h"
#include "geom/gis/footprint_source.h"

namespace geom::gis {

// The format of a file that begins with `head`: CityJSON and CityGML by what they say, OSM by its
// name, height models by what GDAL makes of them; any other is kVector.
const FootprintFormat& footprint_format_of(std::string_view head, const std::string& path);

// A file that is open, and where it lies, because GDAL and libosmium open it again.
struct InputPath {
  const std::string& path;
  const std::string& name;  // for messages
  std::istream& file;
};

// Throws InputError, also where there is no footprint.
Source read(const FootprintFormat& format, const InputPath& in, const ReadOptions& options);

}  // namespace geom::gis
