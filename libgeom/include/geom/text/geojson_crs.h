#pragma once

// The coordinate reference system that a GeoJSON file names.

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace geom {

inline constexpr std::string_view kForeignCrs =
    "crs must be CRS84 (WGS 84 longitude, latitude) or absent, found another: convert the file to "
    "WGS 84";

// Whether an object of the file says that its coordinates are not WGS 84 longitudes and latitudes.
// RFC 7946 knows no "crs"; the older GeoJSON of 2008 did, and some programs say the usual one.
bool has_foreign_crs(const nlohmann::json& object);
bool has_foreign_crs(const nlohmann::ordered_json& object);

}  // namespace geom
