#pragma once

// What a map's history says that nobody knows of its space.
//
// Example:
//   assert(!geom::doubts_of(map.spec()).any());

#include <cstddef>

#include "geom/map/box_map.h"

namespace geom {

struct MapDoubts {
  std::size_t skipped = 0;    // obstacles of the sources that could not be built, and were left out
  bool unknown_free = false;  // space of which a source says nothing counts as free
  bool widened = false;       // bounds were made wider later than the map
  // The share of joined bounds that lies within the bounds of no map that was joined. Of several
  // joins the largest.
  double gap = 0;

  bool any() const { return skipped > 0 || unknown_free || widened || gap > 0; }

  friend bool operator==(const MapDoubts&, const MapDoubts&) = default;
};

MapDoubts doubts_of(const BoxMapSpec& spec);

}  // namespace geom
