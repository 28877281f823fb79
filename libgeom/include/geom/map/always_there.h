#pragma once

// What of a map has no times.

#include "geom/map/box_map.h"

namespace geom {

// The map without the boxes that are there for a time only: the one that these were added to, by
// its hash too, where nothing else was changed. Costs what making a map of the boxes does.
BoxMap always_there(const BoxMap& map);

}  // namespace geom
