#pragma once

// The tube of one cell of disturbances: one nominal flight, and bounds on what differs from it.

#include <optional>
#include <vector>

#include "traj/tube/prove_tube.h"

namespace traj {

// Mean winds and masses that are proved together.
struct TubeCell {
  Vec3 wind = Vec3::Zero();       // m/s: the middle
  double wind_radius = 0;         // m/s: the winds are in a ball of this radius,
  Vec3 wind_half = Vec3::Zero();  // or, where that is 0, in a box of these half sizes
  double mass_least = 1;          // true mass over what is believed
  double mass_most = 1;
  std::vector<int> part;  // as ProvedCell's
  // For a certificate: deviations are taken to be as large as bounds that hold for spans.
  bool by_spans = false;
};

// The simulator may differ from the equations by so much in each coordinate and period, in the
// coordinate's unit (docs/tube.md).
inline constexpr double kSlack = 1e-9;
inline constexpr double kSpinSlack = 1e-7;  // of angular accelerations, which are larger numbers

// A checker of a certificate adds up in another order, so its bounds may be larger by these shares:
// the first for radii and tilt, the second for limits. Limits are on fast coordinates (motors),
// whose sums differ most.
inline constexpr double kCheckersRoom = 1.015;
inline constexpr double kLimitRoom = 1.05;

struct CellTube {
  std::vector<double> radius;          // m, of each kTubePeriod
  double tilt = 0;                     // rad: it never tilts further
  double damping = 1;                  // the least damping ratio of the loop in hover
  std::vector<SpanBounds> spans;       // as ProvedCell's
  std::optional<TubeTrouble> trouble;  // then the rest is not complete
};

CellTube prove_cell(const ReferenceTrack& track, const FlightOptions& options,
                    const Disturbances& disturbances, const TubeCell& cell);

// The same under the cascade.
CellTube prove_cascade_cell(const ReferenceTrack& track, const FlightOptions& options,
                            const Disturbances& disturbances, const TubeCell& cell);

}  // namespace traj
