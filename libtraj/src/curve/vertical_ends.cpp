#include "traj/curve/vertical_ends.h"

#include <algorithm>
#include <vector>

#include <algorithm>

namespace traj {

double ground_below(const geom::CollisionScene& scene, const geom::Vec3& p) {
  const double floor = scene.map().spec().bounds.min.z();
  double ground = floor;
  if (p.z() <= floor) return ground;
  for (const std::size_t i : scene.boxes_meeting({{p.x(), p.y(), floor}, p})) {
    const double top = scene.map().box(i).max.z();
    if (top <= p.z()) ground = std::max(ground, top);
  }
  return ground;
}

namespace {

// Whether closed rectangles in plan cover a closed rectangle: each cell between their edges has one
// that holds it.
bool cover(const std::vector<geom::Aabb>& tops, const geom::Aabb& area) {
  std::vector<double> cuts[2];
  for (int axis = 0; axis < 2; ++axis) {
    cuts[axis] = {area.min[axis], area.max[axis]};
    for (const geom::Aabb& top : tops) {
      for (const double at : {top.min[axis], top.max[axis]}) {
        if (at > area.min[axis] && at < area.max[axis]) cuts[axis].push_back(at);
      }
    }
    std::sort(cuts[axis].begin(), cuts[axis].end());
  }
  for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
    for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j) {
      const auto holds = [&](const geom::Aabb& top) {
        return top.min.x() <= cuts[0][i] && top.max.x() >= cuts[0][i + 1] &&
               top.min.y() <= cuts[1][j] && top.max.y() >= cuts[1][j + 1];
      };
      if (std::none_of(tops.begin(), tops.end(), holds)) return false;
    }
  }
  return true;
}

}  // namespace

LandingGround landing_ground(const geom::CollisionScene& scene, const geom::Vec3& p,
                             const geom::Vec3& beside, double level) {
  const geom::Vec3 half = scene.vehicle().half + beside;
  const double floor = scene.map().spec().bounds.min.z();
  const geom::Aabb area{{p.x() - half.x(), p.y() - half.y(), floor},
                        {p.x() + half.x(), p.y() + half.y(), std::max(floor, p.z())}};
  std::vector<geom::Aabb> below;
  LandingGround ground{floor, true};
  for (const std::size_t i : scene.boxes_meeting(area)) {
    const geom::Aabb box = scene.map().box(i);
    const bool meets = box.max.x() >= area.min.x() && box.min.x() <= area.max.x() &&
                       box.max.y() >= area.min.y() && box.min.y() <= area.max.y();
    if (!meets || box.max.z() > p.z()) continue;
    below.push_back(box);
    ground.height = std::max(ground.height, box.max.z());
  }
  std::erase_if(below, [&](const geom::Aabb& box) { return box.max.z() < ground.height - level; });
  ground.whole = ground.height <= floor + level || cover(below, area);
  return ground;
}

}  // namespace traj
