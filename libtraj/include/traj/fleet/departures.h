#pragma once

// When each flight of a fleet departs, and by which of its ways.
//
// Example:
//   const traj::FleetFlight first{.trajectory = &trajectory, .room = scene.half(), .latest = 600};
//   traj::FleetFlight second = first;  // the same way
//   second.number = 1;
//   const std::vector fleet = {first, second};
//   const traj::FleetConflicts conflicts =
//       traj::fleet_conflicts(fleet, traj::Spacing{}, traj::Parked::gone);
//   const traj::Departures departures = traj::choose_departures(fleet, conflicts);
//   assert(*departures.of[0].start == 0 && *departures.of[1].start > 0);

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "traj/fleet/fleet_conflicts.h"
#include "traj/fleet/fleet_flight.h"

namespace traj {

struct DepartureOptions {
  int improve = 0;         // rounds
  std::uint64_t seed = 0;  // of their order
  int rescue = 0;          // rounds more, as long as a flight is refused
};

// The departure of one number.
struct Departure {
  std::optional<double> start;  // seconds after the epoch; nothing: refused
  std::uint32_t flight = 0;     // which way, an index of the fleet; of a refused one the first
  std::vector<std::uint32_t> blocked;  // of a refused one: flights without which it could depart
};

struct Departures {
  std::vector<Departure> of;  // by number
  double before = 0;          // seconds: the sum of all delays before the rounds
  std::size_t moved = 0;      // flights that rounds moved forward
  std::size_t rescued = 0;    // flights that would be refused without rounds of rescue
};

// Settled flights go first, each at its own time. Then come the others, by priority, then by
// number, each at the earliest time at which it is too near no flight that has a departure already.
// A departure that had to wait is in whole milliseconds after the epoch, rounded up. It takes the
// first of its ways that can depart by its latest.
//
// A round of improvement tries each waiting flight, in an order drawn from the seed. It lets this
// flight go first, then others that wait for the flights in its way, then the flights in its way;
// none of these has a higher priority. The change is kept if the sum of their delays becomes less
// and none is refused for it. A round of rescue does the same; its rounds end when none is
// refused, or nothing may be moved for those that are.
//
// Numbers are 0, 1, 2, …; the flights of a number stand in the order in which they are tried.
// The progress of `run` counts rounds.
Departures choose_departures(std::span<const FleetFlight> flights, const FleetConflicts& conflicts,
                             const DepartureOptions& options = {}, const geom::Execution& run = {});

// How many pairs would be too near if each departed at its earliest, by its first way.
std::size_t conflicts_as_asked(std::span<const FleetFlight> flights,
                               const FleetConflicts& conflicts);

}  // namespace traj
