#pragma once

// Volumes of airspace that hold all returns of a flight: the off-nominal volumes of ASTM F3548.
//
// Example:
//   const traj::FlightReturn of = traj::flight_return(scene, trajectory, {}, 60);
//   const traj::ReturnsOnEarth over{"2026-05-04T06:30:00Z", 12, {47.4, 8.5, 400}, scene.half()};
//   const auto volumes = traj::off_nominal_volumes(of, over, 8, "q1");
//   assert(!traj::why_returns_not_held(of, over, volumes, "q1"));

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/record/volume4d.h"
#include "traj/home/flight_return.h"

namespace traj {

struct ReturnsOnEarth {
  std::string epoch;            // as geom::epoch_from() writes it
  double start = 0;             // s after the epoch at which the flight begins
  geom::GeodeticOrigin origin;  // of the map's (0, 0, 0); its height is known
  Vec3 room = Vec3::Zero();     // m around the reference point along each axis of the map
  geom::Axes axes = geom::Axes::enu;
};

// At most `most` volumes, at least 1: each for the returns that begin in one stretch of the flight,
// of stretches that are as long, from its begin until the last of these returns may have ended
// (longest_seconds, an estimate). Of all returns to home and to each rally point, proved or not.
// Throws geom::InputError(source, …) for times outside of the years 0 to 9999, and for places that
// are not near the origin.
std::vector<geom::Volume4d> off_nominal_volumes(const FlightReturn& flight,
                                                const ReturnsOnEarth& over, std::size_t most,
                                                std::string_view source);

// Nothing where each region of each return, with its room, is in one of the volumes for all of its
// time. Else which is not, in words.
std::optional<std::string> why_returns_not_held(const FlightReturn& flight,
                                                const ReturnsOnEarth& over,
                                                std::span<const geom::Volume4d> volumes,
                                                std::string_view source);

}  // namespace traj
