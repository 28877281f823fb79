#pragma once

// CityGML 1.0, 2.0 and 3.0 (OGC 08-007, 12-019, 20-010): models of cities in GML.

#include <istream>
#include <string>

#include "geom/import/city_model.h"

namespace geom::gis {

struct CityGml {
  CityModel model;  // x, y and z in the order of the file; `crs` is the srsName, as it stands
  // Coordinates of shapes that were placed by a matrix, which need metres along the axes.
  bool placed = false;
};

// All city objects, whatever their module, with all geometries of surfaces: MultiSurface, Solid and
// what they may be made of, triangulated terrain, links within the file in any direction, and
// ImplicitGeometry by its matrix and reference point. Boundary surfaces, doors and the like belong
// to the object that they bound, and to those that link to them; parts, installations and objects
// of modules that are not known here are objects of their own. Heights that attributes tell are
// kept with their unit, and so is the generic attribute `height_attribute`. Of CityGML 3.0 the
// height is one of the highest point above the lowest ground (gml_height.h).
//
// Skipped are surfaces with curves or without heights, shapes of other kinds or in other files, and
// links that lead nowhere or to two shapes, except those to what is only related. Throws
// InputError(name, line, …) for what is no CityGML of these versions, for a number or a tuple
// that is none, for a matrix with another last row than 0 0 0 1, and for two srsNames.
CityGml read_city_gml(std::istream& in, const std::string& name,
                      const std::string& height_attribute);

}  // namespace geom::gis
