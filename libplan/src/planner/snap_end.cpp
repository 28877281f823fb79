#include "plan/planner/snap_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plan {
namespace {

using geom::Vec3;

constexpr double kOutside = 1e-3;   // metres: room to round an end that was moved
constexpr double kFirstRadius = 1;  // metres; doubled until something is found
constexpr std::size_t kMost = 40;   // coordinates an axis: bounds the candidates to 40^3

// Free space is cut by the planes of the faces into cells that are products of intervals, so the
// coordinates of the nearest free place are the point's own or those of faces. Nearest first.
std::vector<double> coordinates(const geom::CollisionScene& scene,
                                const std::vector<std::size_t>& near, const Vec3& p, int axis,
                                double radius) {
  const geom::Aabb& inner = *scene.free_bounds();
  std::vector<double> values = {std::clamp(p[axis], inner.min[axis], inner.max[axis])};
  for (const std::size_t i : near) {
    const geom::Aabb box = scene.grown(i);
    for (const double v : {box.min[axis] - kOutside, box.max[axis] + kOutside}) {
      const bool inside = v >= inner.min[axis] && v <= inner.max[axis];
      if (inside && std::abs(v - p[axis]) <= radius) values.push_back(v);
    }
  }
  std::sort(values.begin(), values.end(), [&](double a, double b) {
    const double da = std::abs(a - p[axis]);
    const double db = std::abs(b - p[axis]);
    return da != db ? da < db : a < b;
  });
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() > kMost) values.resize(kMost);
  return values;
}

// Boxes further away than `radius` cannot decide what is free within it, so none is asked for.
std::optional<Vec3> nearest_within(const geom::CollisionScene& scene, const Vec3& p,
                                   double radius) {
  const Vec3 reach = Vec3::Constant(radius);
  const auto near = scene.boxes_meeting({p - reach, p + reach});
  std::array<std::vector<double>, 3> at;
  for (int axis = 0; axis < 3; ++axis) at[axis] = coordinates(scene, near, p, axis, radius);
  std::optional<Vec3> best;
  double best_distance = radius;
  for (const double x : at[0]) {
    if (std::abs(x - p[0]) > best_distance) break;
    for (const double y : at[1]) {
      if (std::sqrt((x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1])) >
          best_distance * (1 + 1e-12))
        break;
      for (const double z : at[2]) {
        const Vec3 q(x, y, z);
        const double d = (q - p).norm();
        if (best ? d >= best_distance : d > best_distance) break;
        if (!scene.free(q)) continue;
        best = q;
        best_distance = d;
      }
    }
  }
  return best;
}

}  // namespace

std::optional<Vec3> nearest_free(const geom::CollisionScene& scene, const Vec3& p, double radius) {
  if (scene.free(p)) return p;
  if (!scene.free_bounds()) return std::nullopt;
  for (double r = std::min(kFirstRadius, radius);; r = std::min(2 * r, radius)) {
    if (const auto found = nearest_within(scene, p, r)) return found;
    if (r >= radius) return std::nullopt;
  }
}

}  // namespace plan
