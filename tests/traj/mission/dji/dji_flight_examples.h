#pragma once

// Missions of DJI near one place, and how they are flown.

#include "traj/mission/dji/dji_flight.h"

namespace traj::testing {

inline constexpr geom::GeodeticOrigin kOrigin{47, 8, 390};

// Waypoints about 76 m apart, 30 and 35 m above the take-off, which is 100 m south of the first.
inline DjiMission dji_example() {
  DjiMission m;
  m.transit_speed = 9;
  m.takeoff = geom::GeodeticPlace{46.9991, 8, 400};
  m.waylines = {{0, DjiHeights::above_takeoff, {{47, 8, 30, 4, 1.5, 7}, {47, 8.001, 35, 6, 0, 8}}}};
  return m;
}

inline FlownDji fly(const DjiMission& mission, const DjiRules& rules = {}) {
  return flown_dji(mission, {kOrigin, 0}, rules, "m.kmz");
}

// Metres of the example's places.
inline constexpr double kSouth = -100.06;
inline constexpr double kEast = 76.06;

// Three waypoints with a right angle at the second, 76 m east and 100 m north.
inline DjiMission dji_corner(DjiTurn turn, double damping, double height = 30) {
  DjiMission m = dji_example();
  m.waylines[0].waypoints = {
      {47, 8, 30, 4}, {47, 8.001, height, 4}, {47.0009, 8.001, 2 * height - 30, 4}};
  m.waylines[0].waypoints[1].turn = turn;
  m.waylines[0].waypoints[1].damping = damping;
  return m;
}

}  // namespace traj::testing
