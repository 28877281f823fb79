#include "plan/snap_end.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace plan {
namespace {

using geom::Vec3;

constexpr double kOutside = 1e-6;  // metres
constexpr std::size_t kMost = 24;  // coordinates an axis: bounds the candidates to 24^3

// Coordinates along one axis where the nearest free place may lie: the point's own, and just
// outside the faces of what is near, nearest first.
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

}  // namespace

std::optional<Vec3> nearest_free(const geom::CollisionScene& scene, const Vec3& p, double radius) {
  if (scene.free(p)) return p;
  if (!scene.free_bounds()) return std::nullopt;
  const Vec3 reach = Vec3::Constant(radius);
  const auto near = scene.boxes_meeting({p - reach, p + reach});
  std::array<std::vector<double>, 3> at;
  for (int axis = 0; axis < 3; ++axis) at[axis] = coordinates(scene, near, p, axis, radius);
  std::optional<Vec3> best;
  double best_distance = radius;
  for (const double x : at[0]) {
    for (const double y : at[1]) {
      for (const double z : at[2]) {
        const Vec3 q(x, y, z);
        const double d = (q - p).norm();
        if ((best ? d < best_distance : d <= best_distance) && scene.free(q)) {
          best = q;
          best_distance = d;
        }
      }
    }
  }
  return best;
}

}  // namespace plan
