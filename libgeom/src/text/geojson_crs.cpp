#include "geom/text/geojson_crs.h"

#include <nlohmann/json.hpp>

namespace geom {
namespace {

template <class Json>
bool names_another(const Json& object) {
  if (!object.is_object()) return false;
  const auto crs = object.find("crs");
  if (crs == object.end()) return false;
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84",
                           "urn:ogc:def:crs:OGC::CRS84h"}) {
    if (*crs == Json{{"type", "name"}, {"properties", {{"name", name}}}}) return false;
  }
  return true;
}

}  // namespace

bool has_foreign_crs(const nlohmann::json& object) { return names_another(object); }
bool has_foreign_crs(const nlohmann::ordered_json& object) { return names_another(object); }

}  // namespace geom
