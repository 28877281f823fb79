#pragma once

// Planning queries in GeoJSON.

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "geom/record/locator.h"
#include "geom/record/query_record.h"

namespace geom {

// Whether a text that begins so is GeoJSON and not a stream of records.
bool looks_like_geojson(std::string_view text);

// Features of a LineString are queries from its first to its last position; those of Points are
// pairs, from the first to the second of one id. The id is the feature's, or its property id or
// name; a line without one is "q" and its number. A height is the third coordinate or the property
// `height`, metres above the map's zero or a text such as "2above". Throws InputError(source, …)
// that names the feature.
std::vector<PlanQuery> geojson_queries(const nlohmann::json& root, std::string_view source,
                                       const Locator& locator);

}  // namespace geom
