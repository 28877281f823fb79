#pragma once

// The clearance of a curve, for reports: no verdict hangs on it.

#include <optional>
#include <vector>

#include "curve/curve_piece.h"
#include "geom/collision/collision.h"
#include "traj/proof/check.h"

namespace traj {

// To 1 mm; nothing on a map without obstacles.
std::optional<Extreme> least_clearance(const geom::CollisionScene& scene,
                                       const std::vector<Piece>& pieces);

}  // namespace traj
