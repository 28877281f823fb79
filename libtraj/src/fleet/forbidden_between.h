#pragma once

// When two flights must not depart: the differences of departure at which they come too near.

#include <span>
#include <vector>

#include "fleet/course.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/spacing.h"

namespace traj {

// A fiftieth of the least of the zones, in which flights count as straight.
Bend bend_for(std::span<const Zone> zones);

// All d within `window` for which there is an instant at which the second flight, departing d
// seconds after the first, lies in one of the zones around it; as intervals that do not touch, in
// order, cut to the window.
//
// The instants t of the first and s of the second at which they are too near are a set in the
// plane of (t, s), and d = t - s. Each flight is cut into pieces that are straight at a constant
// speed but for a small part of the zone (course_of(), bend_for()); two such pieces are too near
// for (t, s) of a convex polygon, whose corners give the least and the largest d. Rounded outward:
// every d that is truly too near is in the answer. The answer is larger only by what a zone larger
// by up to 1/50 would forbid, and by a microsecond.
//
// Trajectories within domain.h. Segments that miss each other at a joint are padded by the most of
// that, as check_pair() does it. Where a flight parks on its pads, standing there counts for all
// time, so that an interval may be without a begin or an end.
std::vector<DepartureSpan> forbidden_between(const Course& first, const Course& second,
                                             std::span<const Zone> zones,
                                             const DepartureSpan& window);

}  // namespace traj
