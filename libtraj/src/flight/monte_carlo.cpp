#include "traj/flight/monte_carlo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/parallel.h"
#include "geom/random.h"

namespace traj {
namespace {

// The largest error of each period of the tube.
std::vector<double> largest_by_period(const Flight& flight, double duration) {
  const double samples = kTubePeriod / kSamplePeriod;
  const auto bins = static_cast<std::size_t>(std::ceil(duration / kTubePeriod));
  std::vector<double> out(bins, 0);
  for (std::size_t k = 0; k < flight.error.size(); ++k) {
    // A sample on the border of two periods belongs to both.
    const double at = static_cast<double>(k) / samples;
    const auto bin = static_cast<std::size_t>(at);
    if (bin < bins) out[bin] = std::max(out[bin], flight.error[k]);
    if (bin > 0 && bin <= bins && at == std::floor(at)) {
      out[bin - 1] = std::max(out[bin - 1], flight.error[k]);
    }
  }
  return out;
}

}  // namespace

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

TrackingTube fly_often(const SetpointTrack& track, const FlightOptions& base,
                       const MonteCarloOptions& options, const geom::Execution& run) {
  const auto runs = static_cast<std::size_t>(options.runs);
  struct Told {
    bool lost = false;
    Tracking tracking;
    double saturated = 0;
    std::vector<double> largest;
  };
  std::vector<Told> told(runs);
  geom::parallel_for(runs, run, [&](std::size_t i) {
    const Flight flight = simulate(track, drawn(base, options, i), {});
    told[i].lost = flight.lost.has_value();
    if (told[i].lost) return;
    told[i].tracking = tracking(flight, track.duration());
    told[i].saturated = flight.saturated;
    told[i].largest = largest_by_period(flight, track.duration());
  });
  TrackingTube tube;
  for (const Told& t : told) tube.lost += t.lost;
  if (tube.lost) return tube;
  for (const Told& t : told) {
    tube.tracking.push_back(t.tracking);
    tube.saturated += t.saturated / static_cast<double>(runs);
  }
  std::vector<double> errors(runs);
  for (std::size_t bin = 0; bin < told.front().largest.size(); ++bin) {
    for (std::size_t i = 0; i < runs; ++i) errors[i] = told[i].largest[bin];
    tube.radius.push_back(percentile(errors, kTubeShare));
  }
  return tube;
}

}  // namespace traj
