#pragma once

// The least clearance of a way, for reports: no verdict hangs on it.

#include <optional>
#include <vector>

#include "box_times.h"
#include "curve/curve_piece.h"
#include "geom/collision/collision.h"
#include "traj/proof/check.h"

namespace traj {

// A straight line, run through at even speed.
struct Leg {
  Vec3 from;
  Vec3 to;
  double begin;
  double end;
  Vec3 stray = Vec3::Zero();  // how far what is flown may be from it, along each axis
};

// The least distance to the obstacles grown by the vehicle without its margin, and when: of curves
// to 1 mm, of legs to rounding. Nothing on a map without obstacles. Costs what lies about as near
// as the answer.
// A box counts while it is there.
std::optional<Extreme> least_clearance(const geom::CollisionScene& scene, const BoxTimes& times,
                                       const std::vector<Piece>& pieces);
std::optional<Extreme> least_clearance(const geom::CollisionScene& scene,
                                       const std::vector<Leg>& legs);

}  // namespace traj
