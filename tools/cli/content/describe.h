#pragma once

// What is in a map, in words: shared by skyway-info and skyway-map.

#include <nlohmann/json.hpp>

#include "geom/map/box_map.h"

namespace cli {

nlohmann::ordered_json describe(const geom::BoxMap& map);

// The steps that made it, a list.
nlohmann::ordered_json history_of(const geom::BoxMap& map);

// One "key: value" line each; nested objects as JSON.
std::string as_lines(const nlohmann::ordered_json& object);

}  // namespace cli
