#pragma once

// Whether volumes of airspace hold a flight, whole, at every instant.
//
// Example:
//   geom::Volume4d zone{.lower = 400, .upper = 420};
//   zone.outline.centre = {47.4, 8.5, 0};
//   zone.outline.radius = 50;
//   zone.start = "2026-05-04T06:30:00Z";
//   zone.end = "2026-05-04T06:40:00Z";
//   const traj::TimedFlight flight{.trajectory = &trajectory, .room = scene.half()};
//   const traj::FlightOnEarth over{flight, *zone.start, {47.4, 8.5, 400}};
//   const auto why = traj::why_not_held(over, {{zone}}, "intent.json");
//   if (why) std::cout << *why << '\n';

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geom/record/volume4d.h"
#include "traj/together/timed_flight.h"

namespace traj {

struct FlightOnEarth {
  TimedFlight flight;           // the trajectory in east, north, up; what holds must hold its room
  std::string epoch;            // of its start, as geom::epoch_from() writes it
  geom::GeodeticOrigin origin;  // of its coordinates; the height above the ellipsoid is known
};

// Nothing where each volume has both altitudes and both times and, at every instant between these,
// holds the box of the flight's room around its reference point; and where from departure to
// arrival one follows the other without a gap, in order. Else what does not hold, in words.
//
// Proved as check_pair() proves: by the control points of stretches of the curve, which lie within
// the polygon, from each of whose edges a plane keeps them away by its bulge (geom::outline_on_map)
// and 1e-6 m for projecting and rounding; stretches are halved. So edges may be taken as straight
// in degrees, as geodesics or in metres. Throws geom::InputError(source, …) as outline_on_map().
std::optional<std::string> why_not_held(const FlightOnEarth& flight,
                                        std::span<const geom::Volume4d> volumes,
                                        std::string_view source);

}  // namespace traj
