#include "traj/export/in_enu.h"

namespace traj {

Trajectory in_enu(geom::Axes axes, Trajectory trajectory) {
  if (axes == geom::Axes::enu) return trajectory;
  for (Segment& s : trajectory.segments) {
    for (Vec3& p : s.point) p = geom::to_enu(axes, p);
    if (!s.yaw) continue;
    for (double& yaw : *s.yaw) yaw = geom::yaw_to_enu(axes, yaw);
  }
  return trajectory;
}

geom::Polyline in_enu(geom::Axes axes, geom::Polyline path) {
  for (Vec3& p : path) p = geom::to_enu(axes, p);
  return path;
}

}  // namespace traj
