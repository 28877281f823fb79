#pragma once

// What is to be exported.

#include <string>
#include <vector>

#include "geom/record/record.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"

namespace exporting {

// A trajectory record or a path record, in the record's axes.
struct Flight {
  std::string id;
  std::string missing;  // why there is nothing to fly; empty otherwise
  geom::Provenance provenance;
  traj::Limits limits;          // of the record
  traj::Trajectory trajectory;  // of a path: a segment a leg, straight, whose times mean nothing
  geom::Polyline path;          // empty of a trajectory
  double holds = 0;             // s that it stands still in all
  bool has_velocities = false;  // at points of a path
  geom::FlightTime time;
};

// The records of the stream, or those of one id. Two flights do not fit one drone file, so there is
// one, unless there is a file for each (`each`). Throws InputError where there are others, or none.
std::vector<Flight> read_flights(const std::string& input, const std::string& id, bool each);

}  // namespace exporting
