#include "traj/figure/plan_lines.h"

#include "way_points.h"

namespace traj::figure {
namespace {

using geom::figure::PlanLine;

std::vector<Vec3> turned(std::vector<Vec3> points, geom::Axes axes) {
  for (Vec3& point : points) point = geom::to_enu(axes, point);
  return points;
}

}  // namespace

PlanLine plan_line(const geom::PathRecord& path, geom::Axes axes) {
  return {"path", path.id, turned(path.points, axes), true};
}

PlanLine plan_line(const TrajectoryRecord& record, geom::Axes axes) {
  return {"trajectory", record.id, turned(points_of(record.trajectory), axes), false};
}

PlanLine plan_line(const FlightLog& flight) {
  PlanLine line{"flight", flight.id, {}, false};
  for (const FlightSample& sample : flight.samples) line.points.push_back(sample.position);
  return line;
}

}  // namespace traj::figure
