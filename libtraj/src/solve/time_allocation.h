#pragma once

// How long each leg of a path should take: the first guess of every solver, and what the closed
// form is solved with. Only + - * / and square roots.

#include <span>
#include <vector>

#include "traj/curve/trajectory.h"

namespace traj {

struct SpeedProfile {
  double vmax = 1;  // m/s, > 0
  double amax = 1;  // m/s2, > 0, along the path
};

// The least time over `length` metres from speed `from` to speed `to` (m/s): speed up, cruise at
// vmax, slow down. `from` and `to` are taken as given even where amax forbids them.
double leg_time(double length, double from, double to, const SpeedProfile& profile);

// The seconds of each leg, one fewer than `points`, when each is flown at `speed` (m/s, > 0): its
// length / speed. 0 for a leg of no length, here and below.
std::vector<double> even_times(std::span<const Vec3> points, double speed);

// The radius, in metres, of the circle that touches both legs that meet at each point, half the
// shorter leg away from it: infinite where the path goes straight on and at both ends, 0 where it
// turns back.
std::vector<double> turn_radii(std::span<const Vec3> points);

// Each leg at the speed that a cautious pilot would fly it: the least of `cruise` and of
// sqrt(amax * radius) of the turns at its ends, times clearance / comfortable where that is below
// 1; but never below `least * cruise`.
struct Caution {
  double cruise = 1;       // m/s, > 0
  double amax = 1;         // m/s2, > 0, across a turn
  double comfortable = 1;  // metres, > 0, from which on obstacles do not matter
  double least = 0.1;      // share of cruise, > 0
};

// `clearances` holds the metres from each leg to the nearest obstacle or bound.
std::vector<double> cautious_times(std::span<const Vec3> points, std::span<const double> clearances,
                                   const Caution& caution);

// The seconds of each leg when every point is a stop: a trapezoid of speed each.
std::vector<double> stopping_times(std::span<const Vec3> points, const SpeedProfile& profile);

// The speed at each point so that turns taken at `acceleration` cut the corner by at most
// `deviation` metres, and legs are feasible at their amax (a pass forward, then one backward); at
// the ends as given. `legs` has a profile a leg.
struct Turns {
  double acceleration = 1;   // m/s2
  double deviation = 1;      // metres
  bool within_legs = false;  // also with arcs that end half a leg away (turn_radii)
  double first = 0;          // m/s, at the first point
  double last = 0;           // m/s, at the last
};
std::vector<double> corner_speeds(std::span<const Vec3> points, std::span<const SpeedProfile> legs,
                                  const Turns& turns);

// The seconds of each leg at these speeds.
std::vector<double> rolling_times(std::span<const Vec3> points, std::span<const double> speeds,
                                  std::span<const SpeedProfile> legs);

}  // namespace traj
