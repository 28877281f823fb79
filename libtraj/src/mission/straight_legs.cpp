#include "traj/mission/straight_legs.h"

#include <algorithm>
#include <utility>

#include "curve/bernstein.h"

namespace traj {
namespace {

constexpr int kDeepest = 24;

double distance_to_leg(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 leg = b - a;
  const double squared = leg.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - a).dot(leg) / squared, 0.0, 1.0) : 0;
  return (p - (a + s * leg)).norm();
}

// The ends of the parts of a segment whose control points are near their chord.
void flatten(const Segment& s, double tolerance, int depth, geom::Polyline& points) {
  const Vec3& a = s.point.front();
  const Vec3& b = s.point.back();
  const bool flat = std::all_of(s.point.begin(), s.point.end(), [&](const Vec3& p) {
    return distance_to_leg(p, a, b) <= tolerance;
  });
  if (flat || depth == kDeepest) {
    if (points.back() != b) points.push_back(b);
    return;
  }
  const auto [left, right] = split(s);
  flatten(left, tolerance, depth + 1, points);
  flatten(right, tolerance, depth + 1, points);
}

// Ramer 1972, Douglas and Peucker 1973: the farthest point stays while it is farther than allowed.
geom::Polyline simplified(const geom::Polyline& points, double tolerance) {
  std::vector<bool> keep(points.size());
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_leg(points[i], points[first], points[last]);
      if (d > worst) {
        worst = d;
        at = i;
      }
    }
    if (at == first) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  geom::Polyline kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i]) kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

geom::Polyline pushed_off(const geom::CollisionScene& scene, geom::Polyline points,
                          double distance) {
  const auto push = [&](Vec3& p) {
    const Vec3 reach = Vec3::Constant(distance);
    for (const std::size_t i : scene.boxes_meeting({p - reach, p + reach})) {
      const geom::Aabb box = scene.grown(i);
      for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] < box.min[axis]) p[axis] = std::min(p[axis], box.min[axis] - distance);
        if (p[axis] > box.max[axis]) p[axis] = std::max(p[axis], box.max[axis] + distance);
      }
    }
    if (!scene.free_bounds()) return;
    const Vec3 low = scene.free_bounds()->min + reach;
    const Vec3 high = scene.free_bounds()->max - reach;
    if ((low.array() <= high.array()).all()) p = p.cwiseMax(low).cwiseMin(high);
  };
  for (std::size_t i = 1; i + 1 < points.size(); ++i) push(points[i]);
  return points;
}

geom::Polyline straight_legs(const Trajectory& trajectory, double tolerance) {
  geom::Polyline points = {trajectory.segments.front().point.front()};
  for (const Segment& s : trajectory.segments) flatten(s, 0.5 * tolerance, 0, points);
  return simplified(points, 0.5 * tolerance);
}

}  // namespace traj
