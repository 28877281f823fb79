#pragma once

// How high an autopilot's return goes, by its distance from the place to which it returns.
//
// Example:
//   const traj::ReturnModel model = traj::return_model(traj::px4("1.17"));
//   assert(traj::return_heights(model, 30, 100, 120).least == 30);
//   assert(traj::return_heights(model, 30, 3, 4).most == 8);  // twice the distance

#include "traj/home/return_model.h"

namespace traj {

// Metres above its place.
struct HeightRange {
  double least = 0;
  double most = 0;
};

// To which it climbs where it is lower, if `full` is the height of a return from far away, and its
// distance from the place is from `nearest` to `furthest` metres. `least_climb` is left out.
HeightRange return_heights(const ReturnModel& model, double full, double nearest, double furthest);
// Sources: PX4's RTL::calculate_return_alt_from_cone_half_angle, ArduPilot Copter's
// ModeRTL::compute_return_target.

}  // namespace traj
