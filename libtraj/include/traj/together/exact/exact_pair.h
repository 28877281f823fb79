#pragma once

// The exact check of two flights, with its reasons.
//
// Example:
//   const traj::TimedFlight first{.trajectory = &trajectory};
//   const traj::TimedFlight second{.trajectory = &trajectory, .start = 100};
//   const std::vector zones = {traj::cylinder(0.5, 0.5)};
//   assert(traj::check_pair_exactly(first, second, zones, traj::Parked::gone).apart);
//
// It is the proof of traj/together/pair_check.h over again in exact numbers, with reasons that
// anyone can follow.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "traj/proof/exact/exact_check.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace traj {

// A direction from the zone to a piece: a whole multiple of an axis, or upright planes' (x, y, 0).
// All control points lie beyond the plane across it that touches the zone.
using Side = std::array<std::int32_t, 3>;

// The relative curve of a stretch against one zone: its pieces, and a side for each.
struct ApartCover {
  Cover pieces;
  std::vector<Side> sides;
};

struct ExactPair {
  bool apart = false;
  bool undecided = false;  // pieces of 2^-60 of a stretch did not decide it, or they were too many
  std::size_t pieces = 0;
  // A stretch after the other, as docs/certificates.md counts them, and in each a cover a zone; as
  // far as it came.
  std::vector<std::vector<ApartCover>> stretches;
};

// Decides in whole numbers (GMP) what check_pair() decides, by code of its own. What that calls
// apart is apart here. Zones are taken as they are; joints that miss each other count as the
// straight step between. Throws InputError as check_pair().
ExactPair check_pair_exactly(const TimedFlight& a, const TimedFlight& b,
                             std::span<const Zone> zones, Parked parked);

}  // namespace traj
