#pragma once

// Obstacles that move, and the proof that a flight keeps clear of them at every instant.
//
// Example:
//   const traj::TimedFlight flight{.trajectory = &trajectory, .room = scene.half()};
//   const traj::MovingBox drone{.box = {{1, 1, 5}, {2, 2, 6}}, .velocity = {1, 0, 0}, .until = 5};
//   assert(!traj::moving_box_fault(drone));
//   assert(traj::check_moving(flight, drone, traj::Parked::pad).clear);  // it passes 4 m above

#include <cstddef>
#include <optional>

#include "geom/base/error.h"
#include "geom/shape/aabb.h"
#include "traj/together/timed_flight.h"

namespace traj {

inline constexpr double kFastestBox = 1e4;  // m/s along an axis, of a box and of its growth

// A closed box that goes straight on and may grow: at t its faces are at min + (velocity - growth)
// (t - from) and max + (velocity + growth) (t - from). It is there from `from` until `until`, both
// instants included, and at no other.
struct MovingBox {
  geom::Aabb box;                // at `from`; metres in the map's axes
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 growth = Vec3::Zero();    // m/s of each half size, >= 0
  double from = 0;               // seconds after the epoch, each within FlightTime's
  double until = 0;              // > from
};

// Why the obstacle cannot be judged: a number that is not finite or too large, a box
// whose min is above its max, growth below 0, invalid times, or a place on its way beyond
// geom::kLargestCoordinate. Nothing if it can be judged.
std::optional<geom::Fault> moving_box_fault(const MovingBox& box);

struct MovingResult {
  bool clear = false;
  // Not clear, and no instant of contact is known either: they are within rounding of it, or the
  // halvings came to an end.
  bool undecided = false;
  std::size_t pieces = 0;  // that were looked at
  // Where they are not clear: an instant of contact or close to one, and the flight's place then.
  double time = 0;
  Vec3 place = Vec3::Zero();
};

// Decides whether the box of the flight's room, closed, touches the obstacle at any instant; before
// its departure and after its arrival it stands at its first and its last point, or is gone
// (`parked`). By control points of the flight's position less that of each face, on each stretch of
// time between joints (timeline.h): all of them beyond a face is clear, else the stretch is halved.
// "clear" holds in real arithmetic; the obstacle is taken larger by what its faces' places round
// by, 1e-15 of its coordinates. Throws InputError for what
// moving_box_fault() says, and for a flight as check_pair() does.
MovingResult check_moving(const TimedFlight& flight, const MovingBox& box, Parked parked);

}  // namespace traj
