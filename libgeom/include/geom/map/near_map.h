#pragma once

// Volumes that lie elsewhere than the map that is to keep them out.
//
// Example:
//   const std::vector<geom::Vec2> ring = {{9e6, 0}, {9e6 + 5, 0}, {9e6, 5}};
//   assert(geom::why_not_near(map.spec(), {ring}));  // 9000 km away

#include <optional>
#include <span>
#include <string>

#include "geom/map/box_map.h"
#include "geom/shape/polygon.h"

namespace geom {

struct DrawnRing {
  std::span<const Vec2> ring;    // along the map's axes, metres
  bool longitude_first = false;  // whether the file has it so, and may have it wrong
};

// Why the outline is not believed to be meant for the map, or nothing: it lies further from the
// bounds than 10 km and than they are long, or beside them where it would meet them with latitude
// and longitude exchanged. Bounding rectangles decide.
std::optional<std::string> why_not_near(const BoxMapSpec& spec, const DrawnRing& outline);

}  // namespace geom
