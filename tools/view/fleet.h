#pragma once

// Flights that fly at once: when each begins, how late, and how near it comes to others.

#include <optional>
#include <string>
#include <vector>

#include "bundle.h"
#include "cli/content/contents.h"
#include "traj/together/nearest_approach.h"

namespace view {

// More trajectories than this are shown together even where none says when it begins.
inline constexpr std::size_t kMostAlone = 32;

class Fleet {
 public:
  // Of the solved trajectories. Throws geom::InputError where their epochs differ.
  Fleet(const cli::Contents& contents, const geom::Execution& run);

  // Whether there is one: some record says when it begins, there is a check of all against one
  // another, or there are many.
  bool together() const { return together_; }

  // {"start":seconds after the first departure,"delay":…} of a trajectory; nothing where not
  // together.
  void add_times(const traj::TrajectoryRecord& record, Json& motion) const;

  // Epoch, first departure, the nearest approach of each flight as distance, across and up, the
  // nearest pairs, and what the check said and asked.
  Json json(Bundle& bundle) const;

 private:
  struct Pair {
    std::size_t first = 0;  // motions of the page
    std::size_t second = 0;
    double time = 0;    // seconds after the first departure
    double across = 0;  // metres apart then, over the ground and in height
    double up = 0;
    std::string reason;              // of the check; empty where it did not refuse the pair
    std::optional<traj::Zone> zone;  // what was asked of this pair
  };

  std::string hash() const;
  void measure(const geom::Execution& run);
  std::vector<Pair> pairs() const;
  // A check that failed, where there is one, else one of the flights that are shown; null where
  // there is neither.
  const traj::TogetherSummary* verdict() const;

  const cli::Contents& contents_;
  std::vector<const traj::TrajectoryRecord*> flights_;
  bool together_ = false;
  double begin_ = 0;
  std::string hash_;  // of the flights; empty where no check is to be compared with it
  traj::Approaches approaches_;
};

}  // namespace view
