#pragma once

// What is swept where a mission's vehicle passes waypoints without a rest.

#include <cstddef>
#include <span>
#include <vector>

#include "mission/firmware/turn.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// At an item with a place where it waits `hold` seconds: a rest where that lasts until it has
// surely come to the place, since PX4 counts it from where it comes within the radius; ArduPilot
// rests for each whole second.
Turn turn_at(const MissionItem& item, double hold, const MissionRules& rules);

struct Corners {
  std::vector<Sweep> sweeps;
  std::size_t count = 0;   // points between two legs that it passes
  double most_radius = 0;  // m
};

// `turns` and `legs`: one a point (of legs the one that leads there). `braking_way`: metres that it
// needs to stop. Models as mission_flight.h says.
Corners corners_of(std::span<const Vec3> path, std::span<const Turn> turns,
                   std::span<const FlightPart> legs, double braking_way);

}  // namespace traj
