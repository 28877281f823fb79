#pragma once

// Gains of the geometric controller for the least proved tube.
//
// Example, not run:
//   const std::vector<traj::ReferenceTrack> tracks = {traj::ReferenceTrack(trajectory)};
//   traj::FlightOptions options;  // and the vehicle's quadrotor and gains
//   options.law = traj::ControlLaw::geometric;
//   const auto tuned = traj::tune_tube(tracks, options, {.gust_most = 0.5}, {.threads = 4});
//   if (tuned.improved) std::cout << *tuned.cost << " m\n";

#include <span>

#include "traj/flight/tune.h"
#include "traj/tube/prove_tube.h"

namespace traj {

inline constexpr int kTubeTuneRounds = 10;

// A compass search on the logarithms of the gains of position, velocity (across and up), attitude
// and body rates (about x and y), in at most `rounds` rounds: all neighbours of a point are
// proved, the best (ties: the first) is the next, and the step is halved when none is better. The
// cost is the largest radius, m, in the mean over the tracks. No gain moves further than by a
// factor of kMostTubeTuneFactor: sensors are exact here, so that nothing else would hold gains
// down. Where a track has no proof, gains of more damping in hover are better, and a proof is
// better than any of these. Winds and masses are not halved often (kMostTubeTuneCells), so that the
// search takes minutes: a proof of more cells counts as none.
//
// `flights` of the result counts proofs, `before` and `cost` are absent where there is no proof.
// Preconditions as prove_tube(). The same for any number of threads; short tracks take less time.
TuneResult tune_tube(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                     const Disturbances& disturbances, const geom::Execution& run,
                     int rounds = kTubeTuneRounds);

inline constexpr double kMostTubeTuneFactor = 3;
inline constexpr std::size_t kMostTubeTuneCells = 4;

}  // namespace traj
