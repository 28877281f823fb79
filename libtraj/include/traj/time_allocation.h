#pragma once

// How long each leg of a path should take: the first guess of every solver.

#include <span>
#include <vector>

#include "traj/trajectory.h"

namespace traj {

struct SpeedProfile {
  double vmax = 1;  // m/s, > 0
  double amax = 1;  // m/s2, > 0, along the path
};

// The least time over `length` metres from speed `from` to speed `to` (m/s): speed up, cruise at
// vmax, slow down. `from` and `to` are taken as given even where amax forbids them.
double leg_time(double length, double from, double to, const SpeedProfile& profile);

// The seconds of each leg, one fewer than `points`, when every point is a stop. 0 for a leg of no
// length.
std::vector<double> stopping_times(std::span<const Vec3> points, const SpeedProfile& profile);

// The speed at each point so that turns taken at `turn_acceleration` cut the corner by at most
// `deviation` metres, and legs are feasible at profile.amax; 0 at both ends.
struct Turns {
  double acceleration = 1;  // m/s2
  double deviation = 1;     // metres
};
std::vector<double> corner_speeds(std::span<const Vec3> points, const SpeedProfile& profile,
                                  const Turns& turns);

// The seconds of each leg at these speeds.
std::vector<double> rolling_times(std::span<const Vec3> points, std::span<const double> speeds,
                                  const SpeedProfile& profile);

}  // namespace traj
