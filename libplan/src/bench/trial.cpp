#include "plan/bench/trial.h"

#include <algorithm>

namespace plan::bench {

Verdict judge(const geom::CollisionScene& scene, const geom::PlanQuery& query,
              const Answer& answer) {
  if (answer.status == geom::PathStatus::unreachable) {
    return scene.free(query.from) && scene.free(query.to) ? Verdict::unreachable : Verdict::failed;
  }
  if (answer.status != geom::PathStatus::found) return Verdict::failed;
  const geom::Polyline& path = answer.path;
  if (path.empty() || path.front() != query.from || path.back() != query.to) {
    return Verdict::invalid;
  }
  if (!scene.free(path.front())) return Verdict::invalid;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!scene.free(path[i - 1], path[i])) return Verdict::invalid;
  }
  return Verdict::found;
}

Trial trial_of(const geom::CollisionScene& scene, const geom::PlanQuery& query,
               const Answer& answer, double seconds) {
  Trial trial;
  trial.verdict = judge(scene, query, answer);
  trial.seconds = seconds;
  if (trial.verdict == Verdict::found) trial.length = geom::length(answer.path);
  trial.straight = (query.to - query.from).norm();
  trial.best_known = query.best_known;
  trial.expanded = answer.expanded;
  return trial;
}

std::size_t count(const Run& run, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(run.trials.begin(), run.trials.end(),
                    [&](const Trial& trial) { return trial.verdict == verdict; }));
}

}  // namespace plan::bench
