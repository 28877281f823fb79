#pragma once

// One door to all readers of footprints, by the format of the file.
//
// Example:
//   std::ifstream file("blocks.geojson");
//   const std::string path = "blocks.geojson";
//   const std::string format = geom::gis::detect("{\"type\":\"FeatureCollection\"", path);
//   const geom::gis::Source source = geom::gis::read(format, path, path, file, {});
//   assert(!source.footprints.empty());

#include <istream>
#include <string>
#include <string_view>

#include "geom/gis/footprint_source.h"

namespace geom::gis {

// "osm", "cityjson", "citygml", "raster" or "vector", for a file that begins with `head`: CityJSON
// and CityGML by what they say, OSM by its name, height models by what GDAL makes of them.
std::string detect(std::string_view head, const std::string& path);

// `format` as above. `file` is the one at `path`, whose name is for messages. Throws
// InputError, also where there is no footprint.
Source read(const std::string& format, const std::string& path, const std::string& name,
            std::istream& file, const ReadOptions& options);

}  // namespace geom::gis
