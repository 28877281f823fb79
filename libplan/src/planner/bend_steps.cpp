#include "bend_steps.h"

#include <algorithm>

#include "path/shortcut.h"
#include "path/taut.h"
#include "roadmap/bends.h"

namespace plan {

using geom::Polyline;

namespace {

constexpr double kCorridor = 40;    // metres beside a lattice's path that bends are sought in
constexpr double kClose = 4;        // metres beside a path that bends are sought in more closely
constexpr double kClosePart = 3;    // metres: how closely
constexpr double kCloseMost = 150;  // metres between ends: beyond, bends are close enough as it is
constexpr std::size_t kPaths = 4;   // compared once pulled taut
constexpr double kBend = 10;    // metres that bends in the middle of their parts may cost a path
constexpr double kMiddles = 1;  // and mostly cost at most
constexpr double kCorridorPart = 20;          // metres
constexpr double kFinePart = 10;              // metres: of a short path, and for `best`
constexpr double kNearest = 1e-5;             // of a path: `best` does not seek to gain less
constexpr double kBestHaste = 1.01;           // weight of its search along a path
constexpr double kNear = 2e-4;                // of a stretch: less is not sought to be gained
constexpr std::size_t kMostBoxes = 6000;      // around which bends are made for a stretch
constexpr double kCorridorReach = 300;        // metres
constexpr std::size_t kFirstBends = 8000;     // settled before it is known that there is a way
constexpr std::size_t kFromGoalBends = 4000;  // settled the other way round
constexpr std::size_t kCorridorBends = 3000;  // settled at most
constexpr double kStretch = 2000;             // metres of a path that are looked at at once
constexpr std::size_t kStretchBends = 400;    // settled at most where one is half as long or more,
constexpr std::size_t kLooks = 1'000'000;     // and times all bends there: each may look at all
constexpr double kHaste = 1.05;               // weight of the search along a path
constexpr double kRoadmapHaste = 1.02;        // in a roadmap

// The first point of a path that is so many metres after another along it, or else its last.
std::size_t point_after(const Polyline& path, std::size_t first, double metres) {
  double length = 0;
  std::size_t at = first;
  while (at + 1 < path.size() && (at == first || length < metres)) {
    length += (path[at + 1] - path[at]).norm();
    ++at;
  }
  return at;
}

// The part of a path from one of its points to another.
Polyline part_of(const Polyline& path, std::size_t first, std::size_t last) {
  const auto begin = path.begin();
  return {begin + static_cast<std::ptrdiff_t>(first),
          begin + static_cast<std::ptrdiff_t>(last) + 1};
}

void replace_part(Polyline& path, std::size_t first, std::size_t last, const Polyline& by) {
  const auto begin = path.begin() + static_cast<std::ptrdiff_t>(first);
  const auto at = path.erase(begin, begin + static_cast<std::ptrdiff_t>(last - first) + 1);
  path.insert(at, by.begin(), by.end());
}

// How many are compared once pulled taut.
std::size_t paths_for(const Task& task) {
  return task.options.quality == Quality::best ? kPaths : 1;
}

}  // namespace

// The shortest of a roadmap's paths once they are pulled taut.
std::optional<Found> BendSteps::shortest(RoadmapSearch& search, const Task& task,
                                         RoadmapLimits limits, const Polyline& than) const {
  if (limits.paths > 1) limits.beyond = kBend / task.straight();
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
  return std::make_unique<RoadmapSearch>(scene_, *roadmap_);
}

std::optional<Found> BendSteps::by_roadmap(const Task& task, RoadmapLimits limits,
                                           const Polyline& than) {
  std::unique_ptr<RoadmapSearch> search = take();
  if (task.options.quality != Quality::best) limits.weight = kRoadmapHaste;
  limits.paths = paths_for(task);
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
  if (has_roadmap()) return by_roadmap(task, {kCorridorBends}, than);
  if (geom::length(than) <= kStretch) return tighter(task.options, than, paths_for(task));
  PlanOptions quick = task.options;
  quick.quality = Quality::normal;
  auto found = by_stretches(quick, than);
  if (task.options.quality != Quality::best) return found;
  auto closer = by_stretches(task.options, found ? found->path : than);
  return closer ? closer : found;
}

// All that a path shorter than `length` may bend at, or else, where that is too much, what is near
// the path that is known.
std::vector<Bend> BendSteps::bends_for(const Polyline& part, double length, bool best) const {
  const ShortWays ways{part.front(), part.back(), length};
  const double piece = best || geom::length(part) < kCloseMost ? kFinePart : kCorridorPart;
  if (auto bends = bends_within(scene_, piece, ways, kMostBoxes)) return std::move(*bends);
  return bends_along(scene_, piece, part, best ? 2 * kCorridor : kCorridor);
}

// A shorter one of the same ends as `part`, which is a path or a stretch of it.
std::optional<Found> BendSteps::tighter(const PlanOptions& options, const Polyline& part,
                                        std::size_t paths) const {
  if (part.size() < 3) return {};
  const Vec3& from = part.front();
  const Vec3& to = part.back();
  if (scene_.free(from, to)) return Found{{from, to}, {}};
  const double length = geom::length(part);
  const bool best = options.quality == Quality::best;
  if (length - (to - from).norm() < (best ? kNearest : kNear) * length) return {};
  RoadmapLimits limits;
  limits.paths = paths;
  limits.weight = best ? kBestHaste : kHaste;
  limits.shorter = length + kMiddles;
  std::vector<Bend> bends = bends_for(part, limits.shorter, best);
  limits.settled = kCorridorBends;
  if (length > kStretch / 2) {
    limits.settled = std::min(kStretchBends, kLooks / std::max<std::size_t>(bends.size(), 1));
  }
  RoadmapSearch search(scene_, std::move(bends), kCorridorReach);
  return shortest(search, {from, to, options}, limits, part);
}

// A long path is looked at stretch by stretch, each from about the middle of the one before: what a
// search settles grows faster than its distance, and most of what can be gained is gained nearby.
std::optional<Found> BendSteps::by_stretches(const PlanOptions& options,
                                             const Polyline& than) const {
  Polyline path = resample_free(scene_, than, kStretch / 2);
  std::size_t settled = 0;
  for (std::size_t first = 0; first + 2 < path.size();) {
    std::size_t last = std::max(point_after(path, first, kStretch), first + 2);
    const auto found = tighter(options, part_of(path, first, last), 1);
    if (found) {
      settled += found->expanded;
      replace_part(path, first, last, found->path);
      last = first + found->path.size() - 1;
    }
    if (last + 1 == path.size()) break;
    first = std::max(std::min(point_after(path, first, kStretch / 2), last - 1), first + 1);
  }
  Found all{path, {step_of("search", path)}, settled};
  all.path = taut(scene_, path);
  all.steps.push_back(step_of("taut", all.path));
  if (!shorter(all.path, than)) return {};
  return all;
}

std::optional<Found> BendSteps::closer(const Task& task, const Polyline& than) const {
  if (task.options.quality != Quality::best || task.straight() >= kCloseMost) return {};
  RoadmapSearch search(scene_, bends_along(scene_, kClosePart, than, kClose), kCorridorReach);
  return shortest(search, task, {kCorridorBends, kPaths}, than);
}

}  // namespace plan
