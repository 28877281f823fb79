#pragma once

// Counts and sums over a map.
//
// Example:
//   assert(geom::statistics(map).height.most == 8);
//   assert(geom::overlaps(map).pairs == 0);

#include <cstddef>

#include "geom/map/box_map.h"

namespace geom {

struct Quartet {  // of a sorted list: all 0 where it is empty
  double least = 0;
  double median = 0;
  double mean = 0;
  double most = 0;
};

struct MapStatistics {
  Quartet height;           // metres, of the boxes
  Quartet boxes_per_tile;   // of tiles that have any
  std::size_t flat = 0;     // boxes without extent along some axis
  std::size_t unknown = 0;  // boxes labelled "unknown"
};
MapStatistics statistics(const BoxMap& map);

struct Overlaps {
  std::size_t pairs = 0;      // of boxes with more in common than a face; flat boxes count, too
  std::size_t contained = 0;  // boxes inside another (of equal ones all but one)
};

// Cost: n times the boxes around one.
Overlaps overlaps(const BoxMap& map);

}  // namespace geom
