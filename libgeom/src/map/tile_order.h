#pragma once

// Which tile a box belongs to, and the order of boxes.

#include <compare>
#include <cstdint>

#include "geom/map/box_map.h"
#include "geom/shape/aabb.h"

namespace geom {

// Cell indices stay exact in a double and in 32 bits for kLargestCoordinate and tiles of 1 m. Never
// falls as the coordinate rises.
inline std::int32_t cell(double coordinate, double size) {
  const double cells = coordinate / size;
  const auto towards_zero = static_cast<std::int32_t>(cells);
  return towards_zero - (towards_zero > cells);
}

struct Place {
  bool small = true;  // false sorts first: the large tile opens the map
  std::int32_t iy = 0;
  std::int32_t ix = 0;

  friend auto operator<=>(const Place&, const Place&) = default;
};

inline Place place_of(const Aabb& box, double size) {
  const std::int32_t ix = cell(box.min.x(), size);
  const std::int32_t iy = cell(box.min.y(), size);
  const std::int64_t across = static_cast<std::int64_t>(cell(box.max.x(), size)) - ix + 1;
  const std::int64_t along = static_cast<std::int64_t>(cell(box.max.y(), size)) - iy + 1;
  if (across > 4 || along > 4 || across * along > 4) return {false, 0, 0};
  return {true, iy, ix};
}

inline Place place_of(const Tile& tile) { return {!tile.large, tile.iy, tile.ix}; }

// By min, then max.
inline bool comes_before(const Aabb& a, const Aabb& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.min[i] != b.min[i]) return a.min[i] < b.min[i];
  }
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] != b.max[i]) return a.max[i] < b.max[i];
  }
  return false;
}

// -0 and 0 are one value and must be one byte pattern.
inline Aabb canonical(Aabb box) {
  box.min.array() += 0.0;
  box.max.array() += 0.0;
  return box;
}
inline TimeSpan canonical(const TimeSpan& span) { return {span.from + 0.0, span.until + 0.0}; }

}  // namespace geom
