#pragma once

// Convex solids in whole numbers of 2^-1074 m, and whether one is apart from a box.

#include <optional>
#include <utility>
#include <vector>

#include "proof/exact/gmp_bernstein.h"
#include "traj/home/prism.h"

namespace traj::exact {

// Closed.
struct WholeBox {
  Point low;
  Point high;
};

// Along a normal, from the least to the most.
using Extent = std::pair<Whole, Whole>;

// The convex hull of a prism and perhaps of a point. Its normals are those of its faces, and those
// that are across an edge of it and an edge of a box: if one of them has no plane between the
// solid and a box, they meet (but for solids without a volume, which may be apart from a box
// without one).
class Solid {
 public:
  explicit Solid(const Prism& prism, const std::optional<Vec3>& to = {});

  // Whether a plane is strictly between the two.
  bool apart(const WholeBox& box) const;

  bool within(const WholeBox& box) const;

 private:
  void add_plan_normals(const Prism& prism);
  void add_normals_to(const Prism& prism, const Point& to);

  std::vector<Point> corners_;
  std::vector<Point> normals_;
  std::vector<Extent> extents_;  // along these
};

}  // namespace traj::exact
