#include "traj/curve/to_enu.h"

namespace traj {

Trajectory to_enu(geom::Axes axes, Trajectory trajectory) {
  if (axes == geom::Axes::enu) return trajectory;
  for (Segment& s : trajectory.segments) {
    for (Vec3& p : s.point) p = geom::to_enu(axes, p);
    if (!s.yaw) continue;
    for (double& yaw : *s.yaw) yaw = geom::yaw_to_enu(axes, yaw);
  }
  return trajectory;
}

State to_enu(geom::Axes axes, const State& s) {
  return {geom::to_enu(axes, s.position), geom::to_enu(axes, s.velocity),
          geom::to_enu(axes, s.acceleration), geom::to_enu(axes, s.jerk)};
}

geom::Polyline to_enu(geom::Axes axes, geom::Polyline path) {
  for (Vec3& p : path) p = geom::to_enu(axes, p);
  return path;
}

}  // namespace traj
