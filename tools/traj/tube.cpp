#include "tube.h"

#include "cli/run.h"
#include "plan/planner/path_record.h"
#include "plan/planner/plan.h"

namespace solving {

TubeSolver::TubeSolver(const Options& options, cli::Scenes& scenes)
    : options_(options),
      scenes_(scenes),
      rooms_(scenes.map(), {}, geom::Differences::refused, scenes.budget()) {
  if (!scenes.profile()) {
    throw cli::UsageError("--proved-tube: give --vehicle, such as quad2kg or FILE.json");
  }
  task_.profile = *scenes.profile();
  task_.flight = options.flown.flight(task_.profile);
  task_.disturbances = options.flown.disturbances(task_.flight);
}

traj::TubeSolved TubeSolver::solve(const geom::PathRecord& path, const std::string& source,
                                   std::size_t line) {
  traj::TubeTask task = task_;
  if (path.status != geom::PathStatus::found) {
    task.solve.limits = options_.limits_for(task_.profile.vehicle);
    return traj::solve_in_tube(task, path, {}, {});
  }
  geom::Provenance room =
      geom::provenance_of(*scenes_.shared_scene_for(path.provenance, source, line));
  const Task asked = options_.task(*room.vehicle);
  task.solve = asked.options;
  task.yaw = asked.yaw;
  geom::PathRecord known = path;
  known.provenance = room;
  const auto scene = [&](double margin) {
    room.margin = margin;
    return rooms_.shared_scene_for(room, source, line);
  };
  const auto another = [&](const geom::CollisionScene& in) {
    plan::Planner planner(in);
    return plan::path_record(in, path.id, planner.plan(path.points.front(), path.points.back()));
  };
  return traj::solve_in_tube(task, known, {scene, another}, {});
}

}  // namespace solving
