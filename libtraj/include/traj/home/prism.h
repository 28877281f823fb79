#pragma once

// Upright prisms: a convex polygon in plan, from one height to another.
//
// Example:
//   const traj::Prism column = traj::prism_around({{{0, 0, 0}, {2, 0, 0}, {0, 2, 30}}});
//   assert(column.plan.size() == 3 && column.high == 30);
//   assert(traj::meets(column, {{1, 0, 29}, {5, 5, 40}}));
//   assert(!traj::meets(column, {{3, 3, 0}, {5, 5, 40}}));

#include <span>
#include <vector>

#include "geom/base/vec3.h"
#include "geom/shape/aabb.h"
#include "geom/shape/polygon.h"

namespace traj {

using geom::Vec2;
using geom::Vec3;

// Closed. A plan of one or two points is a column or a wall.
struct Prism {
  std::vector<Vec2> plan;  // corners of a convex polygon, counterclockwise
  double low = 0;          // m
  double high = 0;
};

// The corners of the convex hull of these points, counterclockwise from the lowest x; at least one
// point. A point outside of the result by rounding is less than 1e-15 of its coordinates away.
// Andrew, "Another efficient algorithm for convex hulls in two dimensions" (1979).
std::vector<Vec2> plan_hull(std::vector<Vec2> points);

// All sums of a point of the one and a point of the other convex plan, each as plan_hull() makes
// it: their Minkowski sum, as plan_hull() makes it.
std::vector<Vec2> plan_sum(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

// The smallest that holds these points; at least one.
Prism prism_around(std::span<const Vec3> points);

// Its corners, first those at the bottom.
std::vector<Vec3> corners(const Prism& prism);

// Whether it meets the closed box. They count as apart only if that holds after rounding: by a
// plane that is level, or upright and along an edge of either.
bool meets(const Prism& prism, const geom::Aabb& box);

// The same of one prism and many boxes. It has a plan.
class PrismMeeting {
 public:
  explicit PrismMeeting(const Prism& prism);

  const geom::Aabb& bounds() const { return bounds_; }
  bool with(const geom::Aabb& box) const;

 private:
  struct Edge {
    Vec2 begin, out, out_sizes;
    double rounding, size;  // of what is summed up beside the box
  };

  geom::Aabb bounds_;
  std::vector<Edge> edges_;
};

// At most `parts` (>= 1) boxes, side by side along the prism's longer side. Together they hold the
// prism, to rounding. A long prism that lies across the axes fills little of its bounds.
std::vector<geom::Aabb> boxes_around(const Prism& prism, int parts);

// The least distance from a place to the plan, m; 0 inside. To rounding.
double distance(const std::vector<Vec2>& plan, const Vec2& p);
// The largest.
double furthest(const std::vector<Vec2>& plan, const Vec2& p);

}  // namespace traj
