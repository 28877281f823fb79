#include "answer.h"

#include "traj/record/corridor_record.h"
#include "traj/record/duration_bound.h"
#include "traj/record/solved_record.h"

namespace solving {
namespace {

constexpr double kDrawnReach = 10;  // metres: how far a corridor is drawn from its piece

}  // namespace

Solved solve(const geom::CollisionScene& scene, const geom::PathRecord& path, const Task& task) {
  const traj::SolveResult result = traj::solve(scene, traj::waypoints_of(path), task.options);
  traj::TrajectoryRecord record =
      traj::trajectory_record(scene, path.id, result, task.options.limits);
  traj::add_bounds(path, record);
  record.time = path.time;
  if (task.yaw && !record.trajectory.segments.empty()) {
    traj::add_yaw(*task.yaw, record.trajectory);
  }
  return {std::move(record), result.corridor};
}

Solved without_path(const geom::PathRecord& path, const traj::Limits& limits) {
  traj::TrajectoryRecord record;
  record.id = path.id;
  record.status = traj::TrajectoryStatus::no_path;
  record.provenance = path.provenance;
  record.time = path.time;
  record.limits = limits;
  record.message = path.message.empty() ? std::string(name(path.status)) : path.message;
  return {std::move(record)};
}

std::string to_text(const Solved& solved, bool with_corridor) {
  const traj::TrajectoryRecord& record = solved.record;
  const bool solved_one = record.status == traj::TrajectoryStatus::solved && record.rung;
  std::string out(solved_one ? name(*record.rung) : name(record.status));
  out += '\n' + traj::to_json_line(record);
  if (with_corridor) {
    out += traj::to_json_line(record.id, record.provenance, solved.corridor, kDrawnReach);
  }
  return out;
}

Answer parse_answer(std::string_view text) {
  const std::size_t first = text.find('\n') + 1;
  const std::size_t second = text.find('\n', first) + 1;
  return {text.substr(0, first - 1), text.substr(first, second - first), text.substr(second)};
}

}  // namespace solving
