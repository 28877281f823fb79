#pragma once

// The part of the proof that holds a curve against obstacles and bounds.

#include <vector>

#include "box_times.h"
#include "curve/curve_piece.h"
#include "geom/collision/collision.h"
#include "traj/proof/check.h"

namespace traj {

// Notes `reason` and the worst of it.
void note(CheckResult& result, Reason reason, const Largest& worst);

// Notes where the pieces leave the bounds furthest; if none does, where one is deepest in an
// obstacle while that is there, unless all are shown to be clear. Costs what lies near the curve,
// not what lies in the box around it.
void check_place(const geom::CollisionScene& scene, const BoxTimes& times,
                 const std::vector<Piece>& pieces, CheckResult& result);

}  // namespace traj
