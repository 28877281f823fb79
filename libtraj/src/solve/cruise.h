#pragma once

// The middle of long straight legs, flown at constant speed: what an optimiser need not look at.

#include <cstddef>
#include <span>
#include <vector>

#include "traj/proof/limits.h"
#include "traj/solve/corridor.h"

namespace traj {

// Pieces [first, last) of a corridor, and the velocity that all of them are flown at: zero where it
// is left to an optimiser.
struct CruisePart {
  std::size_t first = 0;
  std::size_t last = 0;
  Vec3 velocity = Vec3::Zero();  // m/s

  bool cruises() const { return !velocity.isZero(0); }
  std::span<const CorridorPiece> of(const Corridor& corridor) const {
    return std::span(corridor).subspan(first, last - first);
  }
};

// All of the corridor, in order. Whatever is flown before and after, least time reaches the speed
// that the limits allow along a straight leg and keeps it, once the leg is long enough to get there
// from rest and for the snap to fade, which `rho` (optimize.h) weighs. So a leg cruises between
// those distances from its ends, at joints, and never where the limits leave its speed open. Of two
// cruises at least two pieces lie in between, and before the first and after the last as many.
std::vector<CruisePart> cruise_parts(const Corridor& corridor, const Limits& limits, double rho);

// Straight at that velocity, one segment a piece: as exact as numbers are.
Trajectory cruise(std::span<const CorridorPiece> pieces, const Vec3& velocity);

}  // namespace traj
