#include "traj/flight/tracking.h"

#include <algorithm>
#include <cmath>

#include "geom/base/percentile.h"

namespace traj {

Tracking tracking(const Flight& flight, double duration) {
  const auto end = std::min(static_cast<std::size_t>(std::floor(duration / kSamplePeriod)),
                            flight.error.size() - 1);
  std::vector<double> errors(flight.error.begin(),
                             flight.error.begin() + static_cast<long>(end) + 1);
  Tracking out;
  double squares = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    out.mean += errors[k];
    squares += errors[k] * errors[k];
    if (errors[k] > out.largest) {
      out.largest = errors[k];
      out.largest_time = static_cast<double>(k) / 100;
    }
  }
  out.mean /= static_cast<double>(errors.size());
  out.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  out.arrival = errors.back();
  out.final_distance = flight.final_distance;
  std::size_t settled = flight.error.size();
  while (settled > end && flight.error[settled - 1] <= kSettled) --settled;
  if (settled < flight.error.size()) {
    out.settling =
        settled == end ? 0 : std::max(0.0, static_cast<double>(settled) / 100 - duration);
  }
  out.p99 = geom::percentile(errors, 0.99);
  return out;
}

}  // namespace traj
