#include "home/way_room.h"

#include <algorithm>
#include <vector>

#include "home/clear_region.h"

namespace traj {
namespace {

constexpr double kNarrow = 0.5;  // of a cone: the cosine of its half angle, at least

// All places within `by` metres of one along each axis.
Prism cube(const Vec3& p, double by) {
  const std::vector<Vec3> corners = {p + Vec3(by, by, by), p + Vec3(-by, by, by),
                                     p + Vec3(-by, -by, -by), p + Vec3(by, -by, -by)};
  return prism_around(corners);
}

}  // namespace

WayRoom::WayRoom(const geom::CollisionScene& scene, std::span<const ReturnModel> models)
    : scene_(scene) {
  for (const ReturnModel& model : models) {
    overshoot_ = std::max(overshoot_, model.overshoot_time * model.speed + model.overshoot);
  }
}

// Directions from all places of the region to `to` are in the cone of those from its corners. A
// unit vector of the cone is a sum of these with weights whose sum is at most 1 over the cosine
// between their middle and the furthest of them.
Prism WayRoom::beyond(const Braking& from, const Vec3& to) const {
  std::vector<Vec3> directions;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : from.corners) {
    const double away = (to - p).norm();
    if (away < overshoot_) return cube(to, overshoot_);
    directions.push_back((to - p) / away);
    sum += directions.back();
  }
  const Vec3 middle = sum.normalized();
  double cosine = 1;
  for (const Vec3& d : directions) cosine = std::min(cosine, d.dot(middle));
  if (!(cosine > kNarrow)) return cube(to, overshoot_);
  std::vector<Vec3> places = {to};
  for (const Vec3& d : directions) places.push_back(to + overshoot_ / cosine * d);
  return prism_around(places);
}

Prism WayRoom::beyond(const Vec3& a, const Vec3& b) const {
  const double length = (b - a).norm();
  if (length == 0) return prism_around(std::vector<Vec3>{b});
  const std::vector<Vec3> places = {b, b + overshoot_ / length * (b - a)};
  return prism_around(places);
}

bool WayRoom::joins(const Braking& from, const Vec3& to) const {
  if (!clear_join(scene_, from.region, to, from.stands_on)) return false;
  return overshoot_ == 0 || clear_region(scene_, beyond(from, to));
}

bool WayRoom::leg(const Vec3& a, const Vec3& b) const {
  if (!scene_.free(a, b)) return false;
  return a == b || overshoot_ == 0 || clear_region(scene_, beyond(a, b));
}

}  // namespace traj
