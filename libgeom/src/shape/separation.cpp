#include "geom/shape/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geom/base/precondition.h"
#include "geom/shape/nearest_share.h"

namespace geom {
namespace {

constexpr double kSmallGap = 1e-3;     // metres: below it the nearest points say little
constexpr double kLargestPull = 1e-3;  // metres

void require(const Vec3& from, const Vec3& to, const Aabb& box) {
  require_point("segment", from);
  require_point("segment", to);
  require_point("box", box.min);
  require_point("box", box.max);
}

double lower_support(const Aabb& box, const Vec3& n) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::min(n[i] * box.min[i], n[i] * box.max[i]);
  return sum;
}

// The vector from a point to the nearest point of the box.
Vec3 to_box(const Vec3& p, const Aabb& box) { return p.cwiseMax(box.min).cwiseMin(box.max) - p; }

// The plane of that direction, on whichever side of the box the segment is.
Separation across(const Vec3& normal, const Vec3& from, const Vec3& to, const Aabb& box) {
  const double support = lower_support(box, normal);
  const double gap = support - std::max(normal.dot(from), normal.dot(to));
  return {{normal, support - std::clamp(gap / 2, 0.0, kLargestPull)}, gap};
}

Separation best_axis(const Vec3& from, const Vec3& to, const Aabb& box) {
  Separation best;
  best.gap = -std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& axis) {
    const double size = axis.norm();
    if (!(size > 0)) return;
    for (const double sign : {1.0, -1.0}) {
      const Separation s = across(axis * (sign / size), from, to, box);
      if (s.gap > best.gap) best = s;
    }
  };
  for (int i = 0; i < 3; ++i) consider(Vec3::Unit(i));
  for (int i = 0; i < 3; ++i) consider((to - from).cross(Vec3::Unit(i)));
  return best;
}

}  // namespace

Separation separation(const Vec3& from, const Vec3& to, const Aabb& box) {
  require(from, to, box);
  const Vec3 p = from + nearest_share(from, to, box) * (to - from);
  const Vec3 gap = to_box(p, box);
  const double distance = gap.norm();
  if (distance >= kSmallGap) {
    const Separation s = across(gap / distance, from, to, box);
    if (s.gap >= kSmallGap / 2) return s;
  }
  return best_axis(from, to, box);
}

bool behind(const Aabb& box, const Plane& plane) {
  return lower_support(box, plane.normal) > plane.offset;
}

double distance(const Vec3& from, const Vec3& to, const Aabb& box) {
  require(from, to, box);
  return to_box(from + nearest_share(from, to, box) * (to - from), box).norm();
}

}  // namespace geom
