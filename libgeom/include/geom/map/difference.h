#pragma once

// What one map has and another has not.
//
// Example:
//   const geom::MapDifference change = geom::difference(map, geom::inflate(map, 0.5));
//   assert(change.removed.size() == 1 && change.added.size() == 1);
//   std::cout << geom::to_json_line("added", change.added[0]);

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/box_map.h"

namespace geom {

// Two are the same where box, label and time are; ids do not matter.
struct ChangedBox {
  std::array<double, 6> box;  // lower corner, then upper corner
  std::string label;
  TimeSpan time;
  std::uint64_t id = 0;
};

struct MapDifference {
  std::vector<ChangedBox> removed;  // in an order that no tile size changes
  std::vector<ChangedBox> added;
  bool same_frame = true;
  bool same_bounds = true;
  bool same_epoch = true;

  bool none() const {
    return removed.empty() && added.empty() && same_frame && same_bounds && same_epoch;
  }
};

// Exact. Tile sizes and histories are not compared.
MapDifference difference(const BoxMap& before, const BoxMap& after);

// A record of type "box"; `change`: "removed" or "added".
std::string to_json_line(std::string_view change, const ChangedBox& box);

}  // namespace geom
