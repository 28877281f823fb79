#pragma once

// The differences of departure that are forbidden, for all pairs of a fleet at once.
//
// Example:
//   const traj::FleetFlight first{.trajectory = &trajectory, .room = scene.half(), .latest = 600};
//   traj::FleetFlight second = first;
//   second.number = 1;
//   const std::vector fleet = {first, second};
//   const traj::FleetConflicts conflicts =
//       traj::fleet_conflicts(fleet, traj::Spacing{}, traj::Parked::gone);
//   assert(conflicts.pairs.size() == 1 && conflicts.of(0)[0].holds(0));  // not at once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "traj/fleet/departure_span.h"
#include "traj/fleet/fleet_flight.h"
#include "traj/together/near_pairs.h"
#include "traj/together/spacing.h"

namespace traj {

// The pairs for which some difference of departure, within the earliest and latest ones, is
// forbidden. At all other differences, and in all other pairs, two flights keep apart.
struct FleetConflicts {
  std::size_t looked_at = 0;             // pairs that boxes in space and time did not keep apart
  std::vector<FlightPair> pairs;         // in order
  std::vector<std::uint64_t> ends;       // of each pair's in `forbidden`
  std::vector<DepartureSpan> forbidden;  // second's departure less first's, in order

  std::span<const DepartureSpan> of(std::size_t pair) const {
    const std::uint64_t begin = pair == 0 ? 0 : ends[pair - 1];
    return std::span(forbidden).subspan(begin, ends[pair] - begin);
  }
};

// The forbidden differences of the pairs of which boxes of their pieces meet, each box lasting from
// its piece's time after the earliest departure to that after the latest. So the cost grows with
// the number of flights and of near pairs. Two flights of one number are no pair, and neither are
// two settled ones: nothing is to be chosen between them. The same for any number of threads.
FleetConflicts fleet_conflicts(std::span<const FleetFlight> flights, const Spacing& spacing,
                               Parked parked, const geom::Execution& run = {});

}  // namespace traj
