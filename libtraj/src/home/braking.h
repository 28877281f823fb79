#pragma once

// Where a vehicle comes to rest when it leaves a flight.

#include <optional>
#include <span>
#include <vector>

#include "traj/home/flight_stage.h"
#include "traj/home/prism.h"
#include "traj/home/return_model.h"

namespace traj {

// From a stage, by whichever of the models brakes: it is in the region until it rests.
struct Braking {
  Prism region;
  std::vector<Vec3> corners;
  Vec3 middle = Vec3::Zero();  // a place of the region
  double speed = 0;            // m/s: the fastest in the stage
  std::optional<double> stands_on = {};
};
Braking braking_of(std::span<const ReturnModel> models, const FlightStage& stage);

}  // namespace traj
