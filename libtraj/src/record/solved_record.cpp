#include "traj/record/solved_record.h"

#include <span>

#include "curve/continuity.h"
#include "geom/text/json_line.h"

namespace traj {
namespace {

std::string solver_report(const SolveResult& result) {
  const auto jumps = largest_jumps(result.trajectory);
  geom::JsonLine report;
  report.add("status", result.solver_status).add("rounds", result.rounds);
  report.add("iterations", result.iterations).add("snap", result.snap);
  report.add("jumps", std::span(jumps).first(4));  // the derivatives that are continuous
  return report.object();
}

}  // namespace

TrajectoryRecord trajectory_record(const geom::CollisionScene& scene, std::string id,
                                   const SolveResult& result, const Limits& limits) {
  TrajectoryRecord record;
  record.id = std::move(id);
  record.provenance = geom::provenance_of(scene);
  record.limits = limits;
  record.status = result.status == SolveStatus::solved ? TrajectoryStatus::solved
                                                       : TrajectoryStatus::infeasible;
  record.message = result.reason;
  record.trajectory = result.trajectory;
  record.rung = result.rung;
  if (result.status == SolveStatus::solved) record.solver = solver_report(result);
  return record;
}

std::vector<Waypoint> waypoints_of(const geom::PathRecord& path) {
  std::vector<Waypoint> waypoints = waypoints_at(path.points);
  for (std::size_t i = 0; i < path.hold.size(); ++i) waypoints[i].hold = path.hold[i];
  for (std::size_t i = 0; i < path.velocity.size(); ++i) waypoints[i].velocity = path.velocity[i];
  return waypoints;
}

}  // namespace traj
