#include "judgeable.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/record/flight_time.h"
#include "traj/proof/domain.h"

namespace traj {

void require_judgeable(const TimedFlight& flight) {
  if (const auto outside = outside_domain(*flight.trajectory, {})) {
    throw geom::InputError(
        "flight", {.expected = "a trajectory that a check can judge",
                   .found = fmt::format("one with {} {}", name(outside->reason), outside->value)});
  }
  if (!(std::abs(flight.start) <= geom::kLargestTime)) {
    throw geom::InputError("flight", {.key = "start",
                                      .expected = fmt::format("within {:g} s", geom::kLargestTime),
                                      .found = fmt::to_string(flight.start)});
  }
  for (const double half : flight.room) {
    geom::require_length("room of a flight", half, geom::kLargestCoordinate);
  }
}

void require_judgeable(const Zone& zone) {
  for (const double reach : zone.reach) {
    geom::require_length("reach of a zone", reach, geom::kLargestCoordinate);
  }
}

void require_judgeable(const Spacing& spacing) {
  if (spacing.zone) require_judgeable(*spacing.zone);
  if (spacing.downwash) require_judgeable(*spacing.downwash);
}

}  // namespace traj
