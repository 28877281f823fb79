#pragma once

// City models as their files have them: objects with surfaces, before they are footprints.
//
// Example:
//   geom::CityObject house{.type = "Building", .name = "H1"};
//   house.geometries.push_back(
//       {.lod = 2, .surfaces = {{{{0, 0, 0}, {8, 0, 0}, {8, 6, 0}, {0, 6, 0}}}}});
//   const geom::CityModel model{.objects = {house}, .crs = "EPSG:7415"};

#include <map>
#include <string>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/base/vec3.h"

namespace geom {

using CitySurface = std::vector<std::vector<Vec3>>;  // an outer ring, then holes

struct CityGeometry {
  double lod = 0;
  bool roof_edge = false;   // the outline of a roof, not of the building's ground
  bool roofs_only = false;  // the file says of all surfaces that they are roofs
  std::vector<CitySurface> surfaces;
};

struct CityObject {
  std::string type;  // "Building", "TINRelief", …
  std::string name;
  std::string whole;     // the same for all parts of one, and for that
  bool is_part = false;  // of another
  std::vector<CityGeometry> geometries;
  std::size_t others = 0;  // shapes of points or lines,
  std::size_t drawn = 0;   // and of these, those that draw the object, as lines do an aerial
  bool has_parts = false;
  bool left_out = false;  // gives no footprint, and is not skipped: nobody asked for its type
  std::map<std::string, std::string> attributes;  // heights with their unit: "6.52 m"
};

struct CityModel {
  std::vector<CityObject> objects;
  std::string crs;  // "EPSG:7415", or as the file names it, or empty
  Skipped skipped;  // objects that the reader could not read
};

}  // namespace geom
