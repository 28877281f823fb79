#pragma once

// When two straight pieces are too near, for all pairs of instants at once.

#include <optional>

#include "fleet/course.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/spacing.h"

namespace traj {

// All t - s with t in the first piece, s in the second and the difference of the two positions in
// the zone, wherever within `off` of their lines they are: an interval, as these (t, s) are a
// convex set. Rounded outward; nothing where there are none. `growth`: metres that the reach of the
// zone, which then is a box, grows by from the begin of the first piece to its end, >= 0.
std::optional<DepartureSpan> meeting_times(const StraightPiece& first, const StraightPiece& second,
                                           const Zone& zone, const Vec3& growth = Vec3::Zero());

}  // namespace traj
