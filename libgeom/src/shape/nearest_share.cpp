#include "geom/shape/nearest_share.h"

#include <algorithm>
#include <array>

namespace geom {

// The squared distance is convex and piecewise quadratic, so its slope is piecewise linear between
// the six face crossings.
double nearest_share(const Vec3& from, const Vec3& to, const Aabb& box) {
  const Vec3 step = to - from;
  const auto slope = [&](double t) {
    const Vec3 p = from + t * step;
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).dot(step);
  };
  double left = slope(0);
  if (left >= 0) return 0;
  std::array<double, 7> knot;
  knot.fill(1);
  std::size_t count = 0;
  const auto add = [&](double t) {
    if (t > 0 && t < 1) knot[count++] = t;
  };
  for (int i = 0; i < 3; ++i) {
    if (step[i] == 0) continue;
    add((box.min[i] - from[i]) / step[i]);
    add((box.max[i] - from[i]) / step[i]);
  }
  std::sort(knot.begin(), knot.end());
  double before = 0;
  for (const double t : knot) {
    const double right = slope(t);
    if (right >= 0) return before + (t - before) * (left / (left - right));
    left = right;
    before = t;
  }
  return 1;
}

}  // namespace geom
