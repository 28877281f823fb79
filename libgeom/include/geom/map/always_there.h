#pragma once

// A map without its timed boxes.
//
// Example:
//   const geom::BoxMap lasting = geom::always_there(map);
//   assert(lasting.hash() == map.hash());  // this map has no timed boxes

#include "geom/map/box_map.h"

namespace geom {

// The map without the boxes that are there for a time only. If nothing else was changed, it is the
// map that these boxes were added to, with the same hash. Costs what making a map of the boxes
// does.
BoxMap always_there(const BoxMap& map);

}  // namespace geom
