#pragma once

// An element of a GML document while it is open.

#include <string>

#include "gml_geometry.h"

namespace geom::gis {

// An element that is open, and what it has begun.
struct GmlFrame {
  std::string name;
  int dimension = 3;
  bool reads = false;  // its text
  bool data = false;   // it is data of an object, or in such
  bool object = false;
  bool bounds = false;  // a boundary surface
  bool height = false;  // of CityGML 3.0
  bool shape = false;
  bool polygon = false;
  bool implicit = false;
  bool placed = false;  // a link that a template follows
  double lod = -1;      // of a property of this level of detail
  std::string unit;     // of a height
  std::string generic;  // the name of a generic attribute
  GmlNumbers numbers;
};

}  // namespace geom::gis
