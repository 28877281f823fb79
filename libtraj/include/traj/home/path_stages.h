#pragma once

// Stages of a path that is flown at one speed.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const std::vector<traj::FlightStage> stages = traj::stages_of(record, 5);  // m/s
//   assert(stages.back().until == geom::length(path) / 5);

#include <vector>

#include "geom/record/record.h"
#include "traj/home/flight_stage.h"

namespace traj {

// A stage for each leg, which lasts its length over `speed` (m/s, > 0), and one for each hold.
std::vector<FlightStage> stages_of(const geom::PathRecord& path, double speed);

}  // namespace traj
