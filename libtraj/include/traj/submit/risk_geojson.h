#pragma once

// Risk volumes of one flight as GeoJSON: written for maps, and read back to be proved.
//
// Example:
//   geom::Volume4d zone = traj::volume_around({{{0, 0}, {80, 0}, {80, 30}}, 0, 60}, {47.4, 8.5,
//   400}, "q1"); zone.start = "2026-05-04T06:30:00Z"; zone.end = "2026-05-04T06:40:00Z"; const
//   geom::IntentVolumes intent{{zone}, {}}; const traj::RiskTask task{.rules = {.dimension = 0.7},
//   .speed = 10, .origin = {47.4, 8.5, 400}}; const traj::RiskVolumes risk =
//   traj::risk_volumes(intent, task, "q1"); const std::string text = traj::risk_geojson("q1",
//   intent, risk); assert(traj::read_risk_geojson(text, "q1.geojson").id == "q1");

#include <string>
#include <string_view>

#include "traj/submit/risk_volumes.h"

namespace traj {

// A FeatureCollection: the flight geography (the intent's nominal volumes), the contingency volumes
// and the ground risk buffers, a feature a line, with altitudes above the ellipsoid and times.
// Numbers come back as they are.
std::string risk_geojson(const std::string& id, const geom::IntentVolumes& intent,
                         const RiskVolumes& risk);

struct ReadRisk {
  std::string id;
  std::vector<geom::Volume4d> geography;
  RiskVolumes volumes;
};

// Throws geom::InputError(source, …) for anything that risk_geojson() does not write.
ReadRisk read_risk_geojson(std::string_view text, std::string_view source);

}  // namespace traj
