#pragma once

// A few volumes of airspace that a flight is in, one after the other.
//
// Example:
//   const traj::TimedFlight flight{.trajectory = &trajectory, .room = scene.half()};
//   const traj::FlightOnEarth over{flight, "2026-05-04T06:30:00Z", {47.4, 8.5, 400}};
//   const std::vector<geom::Volume4d> volumes = traj::flight_volumes(over, 4, "q1");
//   assert(!volumes.empty() && !traj::why_not_held(over, volumes, "q1"));

#include <cstddef>
#include <vector>

#include "geom/record/volume4d.h"
#include "traj/mission/airspace/held.h"

namespace traj {

inline constexpr std::size_t kMostVolumes = 64;

// At most `most` volumes, 1 to kMostVolumes, each a convex polygon with altitudes around the
// flight's room for a stretch of time between whole milliseconds of the calendar; each begins when
// the one before ends. Of all ways to cut the flight at 64 instants in equal steps those are
// chosen whose volumes, each times its seconds, come to the least. Degrees are rounded to 1e-9,
// altitudes outward to centimetres, and outlines are wider by what edges may bend and that rounds
// by: a third of a metre for 3 km of straight flight at 45 degrees.
//
// What they hold is for why_not_held() to say. Throws geom::InputError(source, …) for times outside
// of the years 0 to 9999.
std::vector<geom::Volume4d> flight_volumes(const FlightOnEarth& flight, std::size_t most,
                                           std::string_view source);

}  // namespace traj
