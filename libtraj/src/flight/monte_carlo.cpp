#include "traj/flight/monte_carlo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/base/parallel.h"
#include "geom/base/percentile.h"
#include "geom/base/random.h"

namespace traj {
namespace {

// The largest error of each period of the tube, the last of which goes on until the flight ends.
std::vector<double> largest_by_period(const Flight& flight, double duration) {
  const double samples = kTubePeriod / kSamplePeriod;
  const std::size_t bins = tube_periods(duration);
  std::vector<double> out(bins, 0);
  if (bins == 0) return out;
  for (std::size_t k = 0; k < flight.error.size(); ++k) {
    // A sample on the border of two periods belongs to both.
    const double at = static_cast<double>(k) / samples;
    const auto bin = static_cast<std::size_t>(at);
    for (const std::size_t i : {at == std::floor(at) && bin > 0 ? bin - 1 : bin, bin}) {
      double& largest = out[std::min(i, bins - 1)];
      largest = std::max(largest, flight.error[k]);
    }
  }
  return out;
}

}  // namespace

std::size_t tube_periods(double duration) {
  return static_cast<std::size_t>(std::ceil(duration / kTubePeriod));
}

FlightOptions drawn(const FlightOptions& base, const MonteCarloOptions& options, std::size_t i) {
  FlightOptions out = base;
  out.seed = base.seed + 1000003 * (i + 1);
  geom::SplitMix64 random(out.seed);
  const double heading = random.uniform(0, 2 * std::numbers::pi);
  const double share = random.uniform(0, 1);
  const double speed = std::hypot(base.wind.mean.x(), base.wind.mean.y());
  out.wind.mean =
      share * Vec3(speed * std::cos(heading), speed * std::sin(heading), base.wind.mean.z());
  out.mass_error = random.uniform(-options.mass_error, options.mass_error);
  return out;
}

std::vector<RunOutcome> fly_runs(const ReferenceTrack& track, const FlightOptions& base,
                                 const MonteCarloOptions& options, const geom::Execution& run) {
  std::vector<RunOutcome> out(static_cast<std::size_t>(options.runs));
  geom::parallel_for(out.size(), run, [&](std::size_t i) {
    const Flight flight = simulate(track, drawn(base, options, i), {});
    out[i].lost = flight.lost.has_value();
    if (out[i].lost) return;
    out[i].tracking = tracking(flight, track.duration());
    out[i].saturated = flight.saturated;
    out[i].tilt = *std::max_element(flight.tilt.begin(), flight.tilt.end());
    out[i].largest = largest_by_period(flight, track.duration());
  });
  return out;
}

double tube_share(std::size_t runs) {
  const auto all = static_cast<double>(runs);
  return std::min(kTubeShare, std::ceil(kTubeShare * all) / (all + 1));
}

TrackingTube tube_of(std::span<const RunOutcome> outcomes) {
  TrackingTube tube;
  for (const RunOutcome& run : outcomes) tube.lost += run.lost;
  if (tube.lost) return tube;
  for (const RunOutcome& run : outcomes) {
    tube.tracking.push_back(run.tracking);
    tube.saturated += run.saturated / static_cast<double>(outcomes.size());
    tube.tilt = std::max(tube.tilt, run.tilt);
  }
  std::vector<double> errors(outcomes.size());
  for (std::size_t bin = 0; bin < outcomes.front().largest.size(); ++bin) {
    for (std::size_t i = 0; i < outcomes.size(); ++i) errors[i] = outcomes[i].largest[bin];
    tube.radius.push_back(geom::percentile(errors, kTubeShare));
  }
  return tube;
}

}  // namespace traj
