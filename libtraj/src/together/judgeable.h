#pragma once

// Refusals of flights and zones that no check can judge: a comparison with what is not a number
// would keep them apart from all.
//
// Example:
//   require_judgeable(flight);  // InputError where its start is NaN
//   require_judgeable(zone);

#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace traj {

// Throws InputError("flight", …) for a trajectory outside of domain.h, a start that is not within
// kLargestTime, and a room below 0 or not a number.
void require_judgeable(const TimedFlight& flight);

// Throws InputError("zone", …) for a reach that is below 0, beyond 1e8 m or not a number.
void require_judgeable(const Zone& zone);

// Both zones, as far as there are some.
void require_judgeable(const Spacing& spacing);

}  // namespace traj
