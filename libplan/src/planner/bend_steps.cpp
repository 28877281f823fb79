#include "bend_steps.h"

#include <algorithm>

#include "plan/planner/taut.h"

namespace plan {

using geom::Polyline;

namespace {

constexpr double kCorridor = 40;    // metres beside a lattice's path that bends are sought in
constexpr double kClose = 4;        // metres beside a path that bends are sought in more closely
constexpr double kClosePart = 3;    // metres: how closely
constexpr double kCloseMost = 150;  // metres between ends: beyond, bends are close enough as it is
constexpr std::size_t kPaths = 4;   // compared once pulled taut
constexpr double kBend = 10;  // metres that bends in the middle of their parts may cost a path
constexpr double kCorridorPart = 10;          // metres
constexpr double kCorridorReach = 300;        // metres
constexpr std::size_t kFirstBends = 8000;     // settled before it is known that there is a way
constexpr std::size_t kFromGoalBends = 4000;  // settled the other way round
constexpr std::size_t kCorridorBends = 3000;  // settled at most

}  // namespace

// The shortest of a roadmap's paths once they are pulled taut.
std::optional<Found> BendSteps::shortest(RoadmapSearch& search, const Task& task,
                                         RoadmapLimits limits, const Polyline& than) const {
  if (task.options.quality == Quality::best) {
    limits.paths = kPaths;
    limits.beyond = kBend / task.straight();
  }
  const RoadmapResult result = search.search(task.from, task.to, limits);
  std::optional<Found> best;
  for (const Polyline& raw : result.paths) {
    require_free(scene_, raw, "roadmap");
    Found tried{raw, {step_of("search", raw)}, result.settled};
    if (polished(task.options)) {
      tried.path = taut(scene_, raw);
      tried.steps.push_back(step_of("taut", tried.path));
    }
    if (shorter(tried.path, best ? best->path : than)) best = std::move(tried);
  }
  return best;
}

std::unique_ptr<RoadmapSearch> BendSteps::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto search = std::move(idle_.back());
      idle_.pop_back();
      return search;
    }
  }
  return fill_ ? std::make_unique<RoadmapSearch>(scene_, *fill_)
               : std::make_unique<RoadmapSearch>(scene_, *roadmap_);
}

std::optional<Found> BendSteps::by_roadmap(const Task& task, RoadmapLimits limits,
                                           const Polyline& than) {
  std::unique_ptr<RoadmapSearch> search = take();
  auto found = shortest(*search, task, limits, than);
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(search));
  return found;
}

std::optional<Found> BendSteps::at_once(const Task& task) {
  if (auto found = by_roadmap(task, {kFirstBends}, {})) return found;
  // From an end in a yard there are far fewer bends to settle than on the way to it.
  auto found = by_roadmap({task.to, task.from, task.options}, {kFromGoalBends}, {});
  if (found) std::reverse(found->path.begin(), found->path.end());
  return found;
}

std::optional<Found> BendSteps::exhaustively(const Task& task) { return by_roadmap(task, {}, {}); }

std::optional<Found> BendSteps::better(const Task& task, const Polyline& than) {
  RoadmapLimits limits{kCorridorBends};
  if (has_roadmap()) return by_roadmap(task, limits, than);
  const double width = task.options.quality == Quality::best ? 2 * kCorridor : kCorridor;
  RoadmapSearch search(scene_, bends_along(scene_, kCorridorPart, than, width), kCorridorReach);
  limits.weight = task.straight() < 1000 ? 1.02 : 1.04;
  return shortest(search, task, limits, than);
}

std::optional<Found> BendSteps::closer(const Task& task, const Polyline& than) const {
  if (task.options.quality != Quality::best || task.straight() >= kCloseMost) return {};
  RoadmapSearch search(scene_, bends_along(scene_, kClosePart, than, kClose), kCorridorReach);
  return shortest(search, task, {kCorridorBends}, than);
}

}  // namespace plan
