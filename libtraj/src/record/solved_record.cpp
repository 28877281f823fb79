#include "traj/record/solved_record.h"

#include <fmt/format.h>

#include "traj/curve/continuity.h"

namespace traj {
namespace {

std::string solver_report(const SolveResult& result) {
  std::string out = R"({"status":)";
  geom::append_json(out, std::string_view(result.solver_status));
  out += fmt::format(R"(,"rounds":{},"iterations":{},"snap":)", result.rounds, result.iterations);
  geom::append_json(out, result.snap);
  const auto jumps = largest_jumps(result.trajectory);
  for (std::size_t d = 0; d <= 3; ++d) {
    out += d ? "," : R"(,"jumps":[)";
    geom::append_json(out, jumps[d]);
  }
  return out + "]}";
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
