#pragma once

// When two straight pieces are too near, for all pairs of instants at once.

#include <optional>

#include "fleet/course.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/spacing.h"

namespace traj {

// All t - s with t in the first piece, s in the second and the difference of the two positions in
// the zone, wherever within `off` of their lines they are: an interval, as these (t, s) are a
// convex set. Rounded outward; nothing where there are none.
std::optional<DepartureSpan> meeting_times(const StraightPiece& first, const StraightPiece& second,
                                           const Zone& zone);

}  // namespace traj
