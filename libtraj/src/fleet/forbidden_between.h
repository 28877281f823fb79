#pragma once

// forbidden_departures() of flights that are cut into pieces already.

#include <span>
#include <vector>

#include "fleet/course.h"
#include "traj/fleet/departure_span.h"
#include "traj/together/spacing.h"

namespace traj {

// A fiftieth of the least of the zones, in which flights count as straight.
Bend bend_for(std::span<const Zone> zones);

std::vector<DepartureSpan> forbidden_between(const Course& first, const Course& second,
                                             std::span<const Zone> zones,
                                             const DepartureSpan& window);

}  // namespace traj
