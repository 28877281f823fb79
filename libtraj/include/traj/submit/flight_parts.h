#pragma once

// What a folder for an authority has of one flight, each part proved as it is read back.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   record.limits[traj::Limit::speed] = 10;
//   record.time = {.epoch = "2026-05-04T06:30:00Z", .start = 12};
//   traj::SubmissionMethod method{.origin = {47.4, 8.5, 400}};
//   method.risk.dimension = 0.7;
//   const traj::SubmittedTrajectory flight(scene, record, method, {}, "t.jsonl", 1);
//   assert(traj::flight_parts(flight, map).id == "q1");

#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "traj/submit/risk_volumes.h"
#include "traj/submit/submission.h"
#include "traj/submit/submitted_flight.h"

namespace traj {

struct FlightParts {
  std::string id;
  std::string refusal;              // why there is nothing else; empty: there is
  std::string volumes;              // volumes_json()
  std::string risk;                 // risk_geojson()
  std::string certificate;          // of a trajectory
  FlightClaims claims;              // without the names of files
  std::vector<RiskVolume> buffers;  // of ground risk
};

// `map`: of the flight's scene. Throws as the flight does.
FlightParts flight_parts(const SubmittedFlight& flight, const geom::BoxMap& map);

}  // namespace traj
