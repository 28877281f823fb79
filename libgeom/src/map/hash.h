#pragma once

// The hash of a map: of what it is, whatever the size of its tiles.

#include <span>
#include <string>

#include "geom/base/sha256.h"
#include "geom/map/box_map.h"
#include "timed_boxes.h"

namespace geom {

// Sums up a map whose boxes come in their order.
class MapHash {
 public:
  // Of a map with so many boxes that are not always there; these need an epoch.
  MapHash(const BoxMapSpec& spec, std::size_t timed);

  // The next boxes by min, then max; -0 is no coordinate (canonical()).
  void add(std::span<const Aabb> boxes) { sum_.update(std::as_bytes(boxes)); }

  // Once all boxes are added: `boxes` in any order, and which of them are timed.
  std::string text(std::span<const Aabb> boxes, const TimedBoxes& timed);

 private:
  Sha256 sum_;
};

// "sha256:" and 64 hexadecimal digits: of frame, CRS, origin, bounds and the boxes by min, then
// max; where some boxes are not always there, of the epoch and of these with their times, too.
// Precondition: each box is in its tile, and those of a tile are in order; `timed` has no fault.
// Takes a few tens of megabytes and what the timed boxes take, whatever the size of the map.
std::string hash_of(const BoxMapSpec& spec, std::span<const Tile> tiles,
                    std::span<const Aabb> boxes, const TimedBoxes& timed, const Execution& run);

}  // namespace geom
