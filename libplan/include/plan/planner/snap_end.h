#pragma once

// Moving a blocked or outside end of a query to the nearest free place.
//
// Example:
//   const geom::Vec3 inside(4.2, 4, 4);  // in the block
//   const auto near = plan::nearest_free(scene, inside, 2);
//   assert(near && scene.free(*near) && (*near - inside).norm() < 1);

#include <optional>

#include "geom/collision/collision.h"

namespace plan {

// Metres that an end that was moved keeps on every side, beyond vehicle and margin. Drone files
// round: a Tello's by 5 mm an axis, WPL by 6 mm and its vehicle once more by 1.1 cm. Both fit into
// it, so that what is exported from there is not refused by millimetres.
inline constexpr double kSnapRoom = 0.03;

// Where there is no such place, as in a narrow gap: room for the rounding of a number in a text.
inline constexpr double kTightRoom = 1e-3;

// Whether the vehicle, with margin and `room` metres more on every side, is inside the bounds and
// touches no obstacle at `p`.
bool has_room(const geom::CollisionScene& scene, const geom::Vec3& p, double room);

// The nearest point within `radius` metres of `p` (closed) that has kSnapRoom, where it is no more
// than 1 m further than the nearest that has kTightRoom; else the latter; nothing when there is
// none. `p` itself when it is free. To a micrometre. Where more than 40 faces an axis lie within
// the distance, the furthest of them are left out.
std::optional<geom::Vec3> nearest_free(const geom::CollisionScene& scene, const geom::Vec3& p,
                                       double radius);

}  // namespace plan
