#pragma once

// Shares of a fleet's conflicts: what some of the pairs forbid.
//
// Example:
//   const traj::FleetConflicts none;
//   const geom::PartArrays arrays = traj::arrays_of(none, 0);  // for geom::write_shard()

#include <span>

#include "geom/archive/shard_file.h"
#include "traj/fleet/fleet_conflicts.h"

namespace traj {

// `flights`: how many ways the fleet has. The arrays own their bytes but for the ends, which are
// the conflicts'.
geom::PartArrays arrays_of(const FleetConflicts& conflicts, std::size_t flights);

// Of all shards of such a run, in their order. Throws geom::InputError where they are of another
// kind or cannot be of so many flights.
FleetConflicts joined_departures(std::span<const geom::ShardFile> shards, std::size_t flights);

}  // namespace traj
