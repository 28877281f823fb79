#pragma once

// The coordinate reference system that a GeoJSON file names.
//
// Example, not run:
//   const nlohmann::json file = {{"type", "FeatureCollection"},
//                                {"crs", {{"properties", {{"name", "EPSG:25832"}}}}}};
//   if (geom::has_foreign_crs(file)) throw geom::InputError("zones.geojson", geom::foreign_crs());

#include <nlohmann/json_fwd.hpp>

#include "geom/base/error.h"

namespace geom {

// What readers of GeoJSON say of coordinates that has_foreign_crs() finds.
inline Fault foreign_crs() {
  return {.key = "crs",
          .expected = "CRS84 (WGS 84 longitude, latitude) or absent",
          .found = "another",
          .advice = "convert the file to WGS 84"};
}

// Whether an object of the file says that its coordinates are not WGS 84 longitudes and latitudes.
// RFC 7946 knows no "crs"; the older GeoJSON of 2008 did, and some programs say the usual one.
bool has_foreign_crs(const nlohmann::json& object);
bool has_foreign_crs(const nlohmann::ordered_json& object);

}  // namespace geom
