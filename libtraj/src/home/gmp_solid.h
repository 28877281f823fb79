#pragma once

// Convex solids in whole numbers of 2^-1074 m, and whether one is apart from a box; and the same by
// rounded numbers, where these are enough.

#include <optional>
#include <utility>
#include <vector>

#include "geom/shape/aabb.h"
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

// The same solid by rounded numbers. Its "surely" holds in real numbers: any plane that is between
// the two, by more than the rounding of where they lie along its normal, keeps them apart.
class RoughSolid {
 public:
  explicit RoughSolid(const Prism& prism, const std::optional<Vec3>& to = {});

  bool surely_apart(const geom::Aabb& box) const;
  const geom::Aabb& around() const { return around_; }

 private:
  struct Along {
    Vec3 normal;
    double least;
    double most;
    double size;  // of the sums of products
  };
  void add(const Vec3& normal);

  std::vector<Vec3> corners_;
  geom::Aabb around_;
  std::vector<Along> along_;
};

}  // namespace traj::exact
