#pragma once

// Shards of Monte Carlo runs: how a share of the runs of each trajectory went.

#include <span>
#include <vector>

#include "sharding.h"
#include "traj/flight/monte_carlo.h"

namespace cli {

// `outcomes[i]`: those of trajectory i, of the runs that the shard takes of `runs`.
void write_shard(const Sharding& sharding, const std::string& file,
                 std::span<const std::vector<traj::RunOutcome>> outcomes, int runs);

// The runs of all shards.
class JoinedRuns {
 public:
  // Of open_shards(). Throws geom::InputError where they are of another kind or do not fit.
  explicit JoinedRuns(std::vector<ShardFile> shards);

  std::size_t trajectories() const { return trajectories_; }

  // All runs of a trajectory that lasts so long, in their order. Throws geom::InputError where
  // they cannot be of one.
  std::vector<traj::RunOutcome> outcomes(std::size_t trajectory, double duration) const;

 private:
  traj::RunOutcome outcome(const ShardFile& shard, std::size_t row, std::size_t periods) const;

  std::vector<ShardFile> shards_;  // mapped
  std::size_t trajectories_ = 0;
  std::size_t runs_ = 0;  // of each
};

}  // namespace cli
