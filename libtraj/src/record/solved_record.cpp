#include "traj/record/solved_record.h"

#include <span>

#include "curve/continuity.h"
#include "geom/text/json_line.h"
#include "traj/record/duration_bound.h"

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

SolvedRecord solve_record(const geom::CollisionScene& scene, const geom::PathRecord& path,
                          const SolveOptions& options, const std::optional<YawOptions>& yaw) {
  if (path.status != geom::PathStatus::found) return {without_path(path, options.limits)};
  const SolveResult result = solve(scene, waypoints_of(path), options);
  TrajectoryRecord record = trajectory_record(scene, path.id, result, options.limits);
  add_bounds(path, record);
  record.time = path.time;
  if (yaw && !record.trajectory.segments.empty()) add_yaw(*yaw, record.trajectory);
  return {std::move(record), result.corridor};
}

TrajectoryRecord without_path(const geom::PathRecord& path, const Limits& limits) {
  TrajectoryRecord record;
  record.id = path.id;
  record.status = TrajectoryStatus::no_path;
  record.provenance = path.provenance;
  record.time = path.time;
  record.limits = limits;
  record.message = path.message.empty() ? std::string(name(path.status)) : path.message;
  return record;
}

}  // namespace traj
