#pragma once

// To which place a vehicle returns: home, or a rally point.
//
// Example:
//   const traj::ReturnModel model = traj::return_model(traj::px4("1.17"));
//   const std::vector<traj::ReturnPlace> places{{{50, 0, 0}, 20}, {{0, 0, 0}}};  // home last
//   traj::FlightStage stage;
//   stage.where = {{40, 0, 30}};
//   assert(traj::likely_places(model, stage, places) == std::vector<std::size_t>{0});

#include <cstddef>
#include <vector>

#include "traj/home/flight_stage.h"
#include "traj/home/return_model.h"

namespace traj {

// Where a return ends: the ground there, and for a rally point the height that it has in the air.
struct ReturnPlace {
  Vec3 ground = Vec3::Zero();  // m
  double above_ground = 0;     // m
};

// Which of the places, home last, a return that begins in the stage may go to: the nearest, and
// those that may be the nearest for all that the firmware and `around` leave open.
std::vector<std::size_t> likely_places(const ReturnModel& model, const FlightStage& stage,
                                       const std::vector<ReturnPlace>& places);
// Sources: PX4's RTL::findRtlDestination, ArduPilot's AP_Rally::calc_best_rally_or_home_location.

}  // namespace traj
