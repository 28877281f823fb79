#pragma once

// Convex shapes in plan, and whether two of them meet.

#include <span>
#include <vector>

#include "traj/home/prism.h"

namespace traj {

// The corners of a convex shape, counterclockwise; of a point or a segment one or two.
using Outline = std::vector<Vec2>;

struct PlanBox {
  Vec2 min;
  Vec2 max;
};

PlanBox box_around(const Outline& outline);
PlanBox grown(const PlanBox& box, double by);
bool overlap(const PlanBox& a, const PlanBox& b);
Outline outline_of(const PlanBox& box);

// The hull of the points, each with a box of half sizes `room` around it.
Outline outline_around(std::span<const Vec3> hull, const Vec2& room);
Outline grown(const Outline& outline, double by);

// Whether two shapes overlap by more than `depth` metres in every direction, in double precision:
// for finding fences, not for a proof.
bool meet(const Outline& a, const Outline& b, double depth = 0);

// Whether `inner` lies in `outer`, in double precision.
bool holds(const Outline& outer, const Outline& inner);

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace traj
