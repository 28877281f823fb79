#include "geom/shape/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "geom/base/precondition.h"

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

// Where on the segment the distance to the box is least. The squared distance is convex and
// piecewise quadratic, so its slope is piecewise linear between the six face crossings.
double nearest_parameter(const Vec3& from, const Vec3& step, const Aabb& box) {
  std::array<double, 8> knot{0, 1, 0, 0, 0, 0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    if (step[i] == 0) continue;
    knot[2 + 2 * i] = std::clamp((box.min[i] - from[i]) / step[i], 0.0, 1.0);
    knot[3 + 2 * i] = std::clamp((box.max[i] - from[i]) / step[i], 0.0, 1.0);
  }
  std::sort(knot.begin(), knot.end());
  const auto slope = [&](double t) { return -to_box(from + t * step, box).dot(step); };
  double left = slope(0);
  if (left >= 0) return 0;
  for (std::size_t k = 1; k < knot.size(); ++k) {
    const double right = slope(knot[k]);
    if (right >= 0) {
      return knot[k - 1] + (knot[k] - knot[k - 1]) * (left / (left - right));
    }
    left = right;
  }
  return 1;
}

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
  const Vec3 step = to - from;
  const Vec3 p = from + nearest_parameter(from, step, box) * step;
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
  return to_box(from + nearest_parameter(from, to - from, box) * (to - from), box).norm();
}

}  // namespace geom
