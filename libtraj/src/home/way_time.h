#pragma once

// How long a way home takes at most.

#include <optional>
#include <span>

#include "geom/shape/polyline.h"
#include "geom/vehicle/limits.h"
#include "traj/flight/energy.h"
#include "traj/home/return_model.h"

namespace traj {

// The speeds that one autopilot keeps to on a way home, m/s.
struct WaySpeeds {
  double across = 0;   // over the ground, against the wind
  double fastest = 0;  // without wind
  double climb = 0;
  double descent = 0;
};

// Throws InputError where the wind leaves no speed.
WaySpeeds way_speeds(const ReturnModel& model, const geom::Limits& limits,
                     const std::optional<Energy>& energy);

// Seconds from a speed, m/s, to rest.
double braking_time(const ReturnModel& model, double speed);

// Seconds along a leg from rest to rest, and for a way down to the ground.
double leg_time(const ReturnModel& model, const WaySpeeds& speeds, const Vec3& a, const Vec3& b);
double landing_time(double height);

}  // namespace traj
