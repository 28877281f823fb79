#pragma once

// What a map is, as JSON for people and programs.
//
// Example:
//   std::cout << geom::as_lines(geom::description(map));  // hash: sha256:… and so on

#include <nlohmann/json.hpp>
#include <string>

#include "geom/map/box_map.h"

namespace geom {

// Hash, sizes, frame, bounds, origin, epoch, what was left out, history: what the file says,
// without a look at the boxes.
nlohmann::ordered_json description(const BoxMap& map);

// And heights, boxes a tile, what unknown space became; with `pairs` how many boxes overlap.
nlohmann::ordered_json full_description(const BoxMap& map, bool pairs);

// A line for each member, `key: value`, with what cannot be printed escaped.
std::string as_lines(const nlohmann::ordered_json& object);

}  // namespace geom
