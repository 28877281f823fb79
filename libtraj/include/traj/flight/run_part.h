#pragma once

// Shares of Monte Carlo runs: how some runs of each trajectory went.
//
// Example:
//   const std::vector<std::vector<traj::RunOutcome>> outcomes;  // of no trajectory
//   const geom::PartArrays arrays = traj::arrays_of(outcomes, 100);

#include <span>
#include <vector>

#include "geom/archive/shard_file.h"
#include "traj/flight/monte_carlo.h"

namespace traj {

// `outcomes[i]`: those of trajectory i, of the runs that the share has of `runs`.
geom::PartArrays arrays_of(std::span<const std::vector<RunOutcome>> outcomes, int runs);

// The runs of all shards.
class JoinedRuns {
 public:
  // Of complete_shards(). Throws geom::InputError where they are of another kind or do not fit.
  explicit JoinedRuns(std::vector<geom::ShardFile> shards);

  std::size_t trajectories() const { return trajectories_; }

  // All runs of a trajectory that lasts so long, in their order. Throws geom::InputError where
  // they cannot be of one.
  std::vector<RunOutcome> outcomes(std::size_t trajectory, double duration) const;

 private:
  RunOutcome outcome(const geom::ShardFile& shard, std::size_t row, std::size_t periods) const;

  std::vector<geom::ShardFile> shards_;  // mapped
  std::size_t trajectories_ = 0;
  std::size_t runs_ = 0;  // of each
};

}  // namespace traj
