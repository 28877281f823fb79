#include "plan/planner/snap_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plan {
namespace {

using geom::Vec3;

constexpr double kBeside = 1e-6;    // metres beyond the room asked for, so that it is there exactly
constexpr double kFirstRadius = 1;  // metres; doubled until something is found
constexpr double kFurther = 1;      // metres that kSnapRoom is worth going
constexpr std::size_t kMost = 40;   // coordinates an axis: bounds the candidates to 40^3

// The nearest place that has room, within ever larger distances.
class Search {
 public:
  // `inner` is where the reference point may be with that room.
  Search(const geom::CollisionScene& scene, const Vec3& p, double room, const geom::Aabb& inner)
      : scene_(scene),
        p_(p),
        room_(room),
        inner_(inner),
        inside_(p.cwiseMax(inner.min).cwiseMin(inner.max)) {}

  std::optional<Vec3> within(double radius) const {
    const double away = (inside_ - p_).norm();
    if (away > radius) return std::nullopt;
    for (double r = std::min(away + kFirstRadius, radius);; r = std::min(2 * r, radius)) {
      if (const auto found = nearest(r, away)) return found;
      if (r >= radius) return std::nullopt;
    }
  }

 private:
  // Boxes further away than `radius` cannot decide what is free within it, so none is asked for.
  // What is both in the convex bounds and within `radius` of p is that close to `inside_`.
  std::optional<Vec3> nearest(double radius, double away) const {
    const double close = std::sqrt(std::max(0.0, radius * radius - away * away)) + room_ + kBeside;
    const Vec3 reach = Vec3::Constant(close);
    const auto near = scene_.boxes_meeting({inside_ - reach, inside_ + reach});
    std::array<std::vector<double>, 3> at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = coordinates(near, axis, radius);
    std::optional<Vec3> best;
    double best_distance = radius;
    for (const double x : at[0]) {
      if (std::abs(x - p_[0]) > best_distance) break;
      for (const double y : at[1]) {
        const double across = std::sqrt((x - p_[0]) * (x - p_[0]) + (y - p_[1]) * (y - p_[1]));
        if (across > best_distance * (1 + 1e-12)) break;
        for (const double z : at[2]) {
          const Vec3 q(x, y, z);
          const double d = (q - p_).norm();
          if (best ? d >= best_distance : d > best_distance) break;
          if (!has_room(scene_, q, room_)) continue;
          best = q;
          best_distance = d;
        }
      }
    }
    return best;
  }

  // Free space is cut by the planes of the faces into cells that are products of intervals, so the
  // coordinates of the nearest free place are the point's own or those of faces. Nearest first.
  std::vector<double> coordinates(const std::vector<std::size_t>& near, int axis,
                                  double radius) const {
    std::vector<double> values = {inside_[axis]};
    const double beside = room_ + kBeside;
    for (const std::size_t i : near) {
      const geom::Aabb box = scene_.grown(i);
      for (const double v : {box.min[axis] - beside, box.max[axis] + beside}) {
        const bool inside = v >= inner_.min[axis] && v <= inner_.max[axis];
        if (inside && std::abs(v - p_[axis]) <= radius) values.push_back(v);
      }
    }
    std::sort(values.begin(), values.end(), [&](double a, double b) {
      const double da = std::abs(a - p_[axis]);
      const double db = std::abs(b - p_[axis]);
      return da != db ? da < db : a < b;
    });
    values.erase(std::unique(values.begin(), values.end()), values.end());
    if (values.size() > kMost) values.resize(kMost);
    return values;
  }

  const geom::CollisionScene& scene_;
  const Vec3 p_;
  const double room_;
  const geom::Aabb inner_;
  const Vec3 inside_;  // the point of the bounds that is nearest to p
};

std::optional<Vec3> nearest_with(const geom::CollisionScene& scene, const Vec3& p, double radius,
                                 double room) {
  geom::Aabb inner = *scene.free_bounds();
  inner.min.array() += room + kBeside;
  inner.max.array() -= room + kBeside;
  if ((inner.min.array() > inner.max.array()).any()) return std::nullopt;
  return Search(scene, p, room, inner).within(radius);
}

}  // namespace

bool has_room(const geom::CollisionScene& scene, const Vec3& p, double room) {
  const Vec3 reach = Vec3::Constant(room);
  return scene.inside_bounds(p - reach) && scene.inside_bounds(p + reach) &&
         scene.boxes_meeting({p - reach, p + reach}, 0).has_value();
}

std::optional<Vec3> nearest_free(const geom::CollisionScene& scene, const Vec3& p, double radius) {
  if (scene.free(p)) return p;
  if (!scene.free_bounds()) return std::nullopt;
  const auto tight = nearest_with(scene, p, radius, kTightRoom);
  if (!tight) return std::nullopt;
  const double further = std::min(radius, (*tight - p).norm() + kFurther);
  const auto roomy = nearest_with(scene, p, further, kSnapRoom);
  return roomy ? roomy : tight;
}

}  // namespace plan
