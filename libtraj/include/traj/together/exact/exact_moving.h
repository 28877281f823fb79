#pragma once

// The exact check of a flight and an obstacle that moves, with its reasons.
//
// Example:
//   const traj::TimedFlight flight{.trajectory = &trajectory, .room = scene.half()};
//   const traj::MovingBox drone{.box = {{1, 1, 5}, {2, 2, 6}}, .velocity = {1, 0, 0}, .until = 5};
//   assert(traj::check_moving_exactly(flight, drone, traj::Parked::pad).clear);
//
// It is the proof of traj/together/moving_box.h over again in exact numbers, with reasons that
// anyone can follow.

#include <cstddef>
#include <vector>

#include "traj/proof/exact/exact_check.h"
#include "traj/together/moving_box.h"

namespace traj {

// On which side of the obstacle all of a piece lies, grown by the flight's room: beyond its upper
// face across an axis (0, 1 or 2), or below its lower one.
struct FaceSide {
  int axis = 0;
  bool above = true;

  friend bool operator==(const FaceSide&, const FaceSide&) = default;
};

// The flight less the faces on one stretch of time: its pieces, and a side for each.
struct MovingCover {
  Cover pieces;
  std::vector<FaceSide> sides;
};

struct ExactMoving {
  bool clear = false;
  bool undecided = false;  // pieces of 2^-60 of a stretch did not decide it, or they were too many
  std::size_t pieces = 0;
  // All time in which both are there, cut at the flight's joints, in order; as far as it came.
  // Nothing where they are never there at once.
  std::vector<MovingCover> stretches;
  // Where it is not clear: an instant that is not shown, rounded, and the flight's place then.
  double time = 0;
  Vec3 place = Vec3::Zero();
};

// Decides in whole numbers (GMP) what check_moving() decides, by code of its own: times, the way of
// each face, its growth and the room are taken as they are. What that calls clear is clear here.
// Joints that miss each other count as the straight step between. Throws InputError as
// check_moving().
ExactMoving check_moving_exactly(const TimedFlight& flight, const MovingBox& box, Parked parked);

}  // namespace traj
