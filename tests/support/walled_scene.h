#pragma once

// A scene with one obstacle, and a query whose straight line it blocks.

#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "support/small_map.h"

namespace support {

// A wall from floor to ceiling in the middle; the vehicle is a point.
inline const geom::CollisionScene& walled_scene() {
  static const geom::CollisionScene made(
      map_of({{0, 0, 0}, {100, 100, 100}}, {{{48, 20, 0}, {52, 100, 100}}}),
      {"point", geom::Vec3::Zero()}, 0);
  return made;
}

inline const geom::PlanQuery kAcross{"q1", {10, 50, 10}, {90, 50, 10}, 120};

}  // namespace support
