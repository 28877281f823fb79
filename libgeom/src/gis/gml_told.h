#pragma once

// What the text of a GML file holds, to compare with what GDAL reads of it.

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "geom/base/skipped.h"

namespace geom::gis {

struct GmlTold {
  std::size_t geometries = 0;     // that are in no other
  std::size_t polygons = 0;       // also as patches and triangles
  std::set<std::string> systems;  // reference systems of geometries, each as it is written
  std::set<std::string> radii;    // units of arcs about a centre, each as it is written
  bool names_system = false;      // of geometries or of the bounds
};

// Adds one to `skipped` for each member, ring or the like in a GML namespace with an `xlink:href`:
// GDAL passes over them, and what they stand for. Throws as read_xml.
GmlTold told_by_gml(std::string_view text, const std::string& name, Skipped& skipped);

}  // namespace geom::gis
