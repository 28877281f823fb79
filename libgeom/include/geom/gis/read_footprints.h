#pragma once

// The formats that footprints come in, and reading any of them.

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
