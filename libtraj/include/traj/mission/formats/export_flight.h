#pragma once

// A flight that is to become a drone file.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const traj::ExportFlight flight = traj::export_flight(record);
//   assert(flight.path == path);

#include <string>

#include "geom/record/record.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// A trajectory or a path, in the axes of its record.
struct ExportFlight {
  std::string id;
  Trajectory trajectory;     // of a path: a segment a leg, straight, whose times mean nothing
  geom::Polyline path = {};  // empty of a trajectory
  Limits limits = {};        // of the record
  geom::FlightTime time = {};
  double holds = 0;             // s that it stands still in all
  bool has_velocities = false;  // at points of a path
};

// Of a record that was solved, and of one that was found.
ExportFlight export_flight(const TrajectoryRecord& record);
ExportFlight export_flight(const geom::PathRecord& record);

// Why a record holds nothing to fly, by its status and message. Empty: it does.
std::string why_not_flown(const TrajectoryRecord& record);
std::string why_not_flown(const geom::PathRecord& record);

}  // namespace traj
