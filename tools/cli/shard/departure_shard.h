#pragma once

// Shards of a fleet's conflicts: what a share of the pairs forbids.

#include <span>

#include "sharding.h"
#include "traj/fleet/fleet_conflicts.h"

namespace cli {

// `flights`: how many ways the fleet has.
void write_shard(const Sharding& sharding, const std::string& file,
                 const traj::FleetConflicts& conflicts, std::size_t flights);

// Of all shards of such a run, in their order. Throws geom::InputError where they are of another
// kind or cannot be of so many flights.
traj::FleetConflicts joined_departures(std::span<const ShardFile> shards, std::size_t flights);

}  // namespace cli
