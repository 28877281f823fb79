#pragma once

// The coordinate reference system that a GeoJSON file names.
//
// Example:
//   const nlohmann::json file = {{"type", "FeatureCollection"},
//                                {"crs", {{"properties", {{"name", "EPSG:25832"}}}}}};
//   if (geom::has_foreign_crs(file)) std::cerr << geom::kForeignCrs << '\n';

#include <nlohmann/json.hpp>

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
template <class Json>
bool has_foreign_crs(const Json& object) {
  if (!object.is_object()) return false;
  const auto crs = object.find("crs");
  if (crs == object.end()) return false;
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84",
                           "urn:ogc:def:crs:OGC::CRS84h"}) {
    if (*crs == Json{{"type", "name"}, {"properties", {{"name", name}}}}) return false;
  }
  return true;
}

}  // namespace geom
