#pragma once

// The hash of a map: of what it is, whatever the size of its tiles.

#include <span>
#include <string>

#include "geom/map/box_map.h"

namespace geom {

// "sha256:" and 64 hexadecimal digits: of frame, CRS, origin, bounds and the boxes by min, then
// max. Precondition: each box is in its tile, and those of a tile are in order. Takes a few tens of
// megabytes, whatever the size of the map.
std::string hash_of(const BoxMapSpec& spec, std::span<const Tile> tiles,
                    std::span<const Aabb> boxes, const Execution& run);

}  // namespace geom
