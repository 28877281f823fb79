#pragma once

// Reports of simulated flights, as JSON Lines records.
//
// Example:
//   traj::FlightReport report{.id = "q1", .duration = traj::duration(trajectory)};
//   report.tracking = traj::Tracking{};
//   report.provenance = geom::provenance_of(scene);
//   if (traj::accepted(report)) std::cout << to_json_line(report, traj::Airframe{}, &map);

#include <optional>
#include <string>

#include "geom/map/box_map.h"
#include "geom/record/record.h"
#include "traj/flight/airframe.h"
#include "traj/flight/flown_path.h"
#include "traj/flight/monte_carlo.h"
#include "traj/record/trajectory_status.h"
#include "traj/tube/prove_tube.h"

namespace traj {

struct FlightReport {
  std::string id;
  TrajectoryStatus status = TrajectoryStatus::solved;  // another is not flown
  double duration = 0;                                 // s, of the trajectory
  std::string trajectory = {};                         // its trajectory_hash()
  FlightOptions options;
  std::optional<double> lost;        // s
  std::optional<Tracking> tracking;  // of a flight that was not lost
  double saturated = 0;
  double tilt = 0;  // rad, the largest
  double hover_seconds = 0;
  std::optional<FlightPathCheck> check;     // where there is a map
  std::optional<MonteCarloOptions> spread;  // where many were flown
  TrackingTube tube;
  std::optional<FlightPathCheck> tube_check;
  std::optional<Disturbances> disturbances;  // where a tube was to be proved,
  ProvedTube proved;
  std::optional<FlightPathCheck> proved_check;  // and held against the map
  geom::Provenance provenance;
  geom::FlightTime time;
};

// Whether it was flown, was not lost, and is clear as far as that was asked.
bool accepted(const FlightReport& report);

// Why it is not accepted, in the report's word. Precondition: it is not.
std::string_view reason(const FlightReport& report);

// Ends with a newline. `map`, where there is one, gives obstacles' ids in their source. The
// airframe's battery and endurance, if known, give the energy and its share of the battery.
std::string to_json_line(const FlightReport& report, const Airframe& airframe,
                         const geom::BoxMap* map);

}  // namespace traj
