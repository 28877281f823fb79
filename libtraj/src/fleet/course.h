#pragma once

// A flight as straight pieces at constant speed, in a tree of boxes: for times that are not fixed.

#include <array>
#include <cstdint>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/together/timed_flight.h"

namespace traj {

// How far a flight may be from its straight pieces, metres.
struct Bend {
  double across = 0;
  double up = 0;
};

// At the share u of its time (0 to 1) the flight is within `off` of from + u * way.
struct StraightPiece {
  Vec3 from = Vec3::Zero();
  Vec3 way = Vec3::Zero();
  Bend off;
  double begin = 0;  // seconds after departure; infinite where it stands there for ever
  double end = 0;
};

// Holds what it says of pieces, rounded outward: metres and seconds in single precision.
struct CourseBox {
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  float begin = 0;
  float end = 0;
};

struct CourseNode {
  CourseBox box;
  std::uint32_t left = 0;  // 0: a leaf
  std::uint32_t right = 0;
  std::uint32_t piece = 0;  // of a leaf
};

struct Course {
  std::vector<StraightPiece> pieces;  // in order
  std::vector<CourseNode> nodes;      // the root first
  // Seconds that any time here may be off.
  double blur = 0;
};

// Pieces bend by at most `bend`, as far as halvings go. A flight that parks on its pads has two
// pieces more, without begin and without end.
Course course_of(const Trajectory& trajectory, Parked parked, const Bend& bend);

}  // namespace traj
