#pragma once

// Contingency volumes and ground risk buffers around the volumes of airspace of a flight.
//
// Example:
//   geom::Volume4d zone = traj::volume_around({{{0, 0}, {80, 0}, {80, 30}}, 0, 60}, {47.4, 8.5,
//   400}, "q1"); zone.start = "2026-05-04T06:30:00Z"; zone.end = "2026-05-04T06:40:00Z"; const
//   geom::IntentVolumes intent{{zone}, {}}; const traj::RiskTask task{.rules = {.dimension = 0.7},
//   .speed = 10, .origin = {47.4, 8.5, 400}}; const traj::RiskVolumes risk =
//   traj::risk_volumes(intent, task, "q1"); assert(!traj::why_risk_not_held(intent, risk, task,
//   "q1"));

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/record/volume4d.h"
#include "traj/mission/airspace/volume_around.h"
#include "traj/mission/flown/terrain_rules.h"
#include "traj/submit/risk_rules.h"

namespace traj {

struct RiskTask {
  RiskRules rules;
  double speed = 0;                         // m/s: no instant of the flight is faster
  double floor = 0;                         // m in the map's z: no ground below the flight is lower
  geom::GeodeticOrigin origin;              // of the map's (0, 0, 0); its height is known
  std::optional<TerrainRules> ground = {};  // a height model, which the floor must agree with
};

// One contingency volume and the buffer on the ground around it.
struct RiskVolume {
  geom::Volume4d volume;
  double height = 0;  // m of the contingency volume's top above the floor, rounded up
  double across = 0;  // m from the contingency volume to the edge of the buffer
};

struct RiskVolumes {
  std::vector<geom::Volume4d> contingency;
  std::vector<RiskVolume> buffers;  // one for each of these, from the floor up to its top
};

// The volumes around those of an operational intent, in order. Where the vehicle stops: one around
// each nominal volume. For ways home: the nominal and then the off-nominal volumes themselves. Each
// lasts as long as the volume that it surrounds. Throws geom::InputError(source, …) for volumes
// without altitudes, and for volumes far from the origin.
RiskVolumes risk_volumes(const geom::IntentVolumes& intent, const RiskTask& task,
                         std::string_view source);

// Nothing where the risk volumes are as many, and each reaches as far around the intent's as the
// rules ask for, at least for their times; and no ground that the height model knows below a buffer
// is lower than the floor. Else which does not, in words. Sound: rounding counts against them, and
// the ground of the rectangle around a buffer counts as below it.
std::optional<std::string> why_risk_not_held(const geom::IntentVolumes& intent,
                                             const RiskVolumes& risk, const RiskTask& task,
                                             std::string_view source);

}  // namespace traj
