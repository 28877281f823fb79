#pragma once

// Links in the geometries of GML that GDAL reads: it passes over them, and what they stand for.

#include <istream>
#include <string>

#include "geom/base/skipped.h"

namespace geom::gis {

// Adds one to `skipped` for each member, ring or the like in a GML namespace with an `xlink:href`.
// Throws as read_xml.
void skip_unfollowed(std::istream& in, const std::string& name, Skipped& skipped);

}  // namespace geom::gis
