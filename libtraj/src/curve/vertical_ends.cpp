#include "traj/curve/vertical_ends.h"

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

}  // namespace traj
