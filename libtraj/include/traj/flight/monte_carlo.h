#pragma once

// Many flights with wind and mass drawn by chance, and how far they stray: statistics, not proof.
//
// Example:
//   const auto tello = traj::vehicle_named("tello");
//   traj::FlightOptions base{.quadrotor = *traj::quadrotor_of(tello->airframe)};
//   base.gains = *tello->airframe.gains;
//   base.wind.mean = {2, 0, 0};
//   const auto runs = traj::fly_runs(traj::ReferenceTrack(trajectory), base, {.runs = 2}, {});
//   const traj::TrackingTube tube = traj::tube_of(runs);

#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "traj/flight/tracking.h"

namespace traj {

struct MonteCarloOptions {
  int runs = 100;         // >= 1
  double mass_error = 0;  // the mass is off by up to this share, either way
};

// Options of run `i`: the wind's heading anywhere, its speed evenly from none to that of `base`,
// the mass error evenly within the options'; noise and gusts seeded for the run.
FlightOptions drawn(const FlightOptions& base, const MonteCarloOptions& options, std::size_t i);

inline constexpr double kTubePeriod = 0.1;  // s
inline constexpr double kTubeShare = 0.999;

// The share of further flights that stay within a tube of so many: of the largest of n errors drawn
// alike, n / (n + 1) of further ones are smaller, in the mean. At most kTubeShare.
double tube_share(std::size_t runs);

// How a run went.
struct RunOutcome {
  bool lost = false;  // then the rest is empty
  Tracking tracking;
  double saturated = 0;         // share
  double tilt = 0;              // rad, the largest
  std::vector<double> largest;  // m: the largest error in each kTubePeriod
};

// Periods of a trajectory of this duration.
std::size_t tube_periods(double duration);

// The outcomes of all runs, in their order; the same for any number of threads.
std::vector<RunOutcome> fly_runs(const ReferenceTrack& track, const FlightOptions& base,
                                 const MonteCarloOptions& options, const geom::Execution& run);

struct TrackingTube {
  std::size_t lost = 0;            // flights; with any, the rest is empty
  std::vector<double> radius;      // m: the 99.9th percentile of the flights' largest errors in
                                   // each kTubePeriod; the last holds until the flights end,
                                   // which hover behind the trajectory
  std::vector<Tracking> tracking;  // of each run
  double saturated = 0;            // mean share
  double tilt = 0;                 // rad, the largest of all runs
};

// The tube of all runs, at least one, in their order. With fewer than 1,000 the percentile is the
// largest.
TrackingTube tube_of(std::span<const RunOutcome> outcomes);

}  // namespace traj
