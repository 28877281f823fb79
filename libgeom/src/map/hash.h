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
  // `timed`: how many boxes of the map are there for a time only. A map with such boxes has an
  // epoch.
  MapHash(const BoxMapSpec& spec, std::size_t timed);

  // Adds the next boxes. All boxes come in the order of min, then max, and none has a coordinate of
  // -0 (canonical()).
  void add(std::span<const Aabb> boxes) { sum_.update(std::as_bytes(boxes)); }

  // The hash, when all boxes were added. `boxes` may be in any order; `timed` says which of them
  // are there for a time only.
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
