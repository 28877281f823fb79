#include "plan/planner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bend_steps.h"
#include "first_answer.h"
#include "geom/base/precondition.h"
#include "geom/text/counted.h"
#include "lattice_level.h"
#include "path/shortcut.h"
#include "path/taut.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/snap_end.h"
#include "refused_end.h"
#include "shown_point.h"
#include "step.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr double kSpacing = 10;       // metres: of the first lattice on a map of a city's size
constexpr int kLevels = 3;            // each of half the spacing of the one before
constexpr double kFewestNodes = 1e4;  // of the first lattice: a small map gets a finer one
constexpr double kDetour = 1.2;       // of the straight line: then a finer lattice may know better
constexpr double kHaste = 1.1;        // weight where a lattice's path only leads to bends
constexpr double kClimb = 300;        // metres towards the goal, of three legs
constexpr double kCoarser = 2;        // times the first spacing: of a lattice that only leads there

double nodes_at(const geom::Aabb& inner, double spacing) {
  double nodes = 1;
  for (int axis = 0; axis < 3; ++axis) {
    nodes *= std::floor((inner.max[axis] - inner.min[axis]) / spacing) + 1;
  }
  return nodes;
}

// The spacings to try, coarse to fine: a function of the bounds alone.
std::vector<double> spacings_for(const geom::Aabb& inner) {
  double first = kSpacing;
  for (int i = 0; i < 10 && nodes_at(inner, first) < kFewestNodes; ++i) first /= 2;
  std::vector<double> spacings = {first};
  while (spacings.size() < kLevels) spacings.push_back(spacings.back() / 2);
  return spacings;
}

PlanResult with(Found found, Route route, PlanResult result) {
  result.status = PathStatus::found;
  result.route = route;
  result.path = std::move(found.path);
  result.steps = std::move(found.steps);
  result.expanded = found.expanded;
  return result;
}

// Both places at the height of the higher, or at the least above it where nothing is between them;
// nothing where that is out of the bounds.
std::optional<std::pair<Vec3, Vec3>> above_all(const geom::CollisionScene& scene, Vec3 a, Vec3 b) {
  constexpr double kOff = 1e-3;  // metres above the roofs
  a.z() = b.z() = std::max(a.z(), b.z());
  for (auto boxes = scene.blockers(a, b); !boxes.empty(); boxes = scene.blockers(a, b)) {
    for (const std::size_t i : boxes) a.z() = std::max(a.z(), scene.grown(i).max.z() + kOff);
    b.z() = a.z();
  }
  if (!scene.free(a, b)) return std::nullopt;
  return std::pair(a, b);
}

// Whether a lattice's path only leads to bends.
bool guides(const Task& task) {
  return task.options.method == kAutomatic && polished(task.options);
}

std::string why_not(const PlanResult& result) {
  if (result.status == PathStatus::stopped) {
    return fmt::format("the search was given up: a lattice with nodes every {} m has too many",
                       result.resolution);
  }
  return fmt::format("no path on a lattice with nodes every {} m", result.resolution);
}

}  // namespace

struct Planner::Impl {
  Impl(const geom::CollisionScene& scene, const Lattice* lattice, const Roadmap* roadmap);

  PlanResult plan(const Vec3& from, const Vec3& to, const PlanOptions& options);

  PlanResult by_recipe(const Task& task);
  PlanResult by_method(const Task& task);
  PlanResult by_sampling(const Task& task, SamplingMethod method);
  std::optional<FirstAnswer> by_three_legs(const Task& task);
  PlanResult first_or_lattices(const Task& task, std::optional<ReachResult> reached);
  PlanResult by_lattices(const Task& task, std::optional<ReachResult> reached);
  PlanResult by_cells(const Task& task, ReachResult reached, PlanResult tried) const;
  PlanResult by_level(LatticeLevel& level, const Task& task);
  PlanResult shortened(PlanResult result, const Task& task) const;

  const geom::CollisionScene& scene_;
  BendSteps bends_;
  Reach reach_;
  Bounder bounder_;
  std::unique_ptr<LatticeLevel> guide_;                       // before the first of our own
  std::vector<std::unique_ptr<LatticeLevel>> levels_;         // from the first to try to finer ones
  std::vector<std::unique_ptr<LatticeLevel>> coarse_levels_;  // for where the first are too large
};

Planner::Impl::Impl(const geom::CollisionScene& scene, const Lattice* lattice,
                    const Roadmap* roadmap)
    : scene_(scene), bends_(scene, roadmap), reach_(scene), bounder_(scene) {
  const auto lazy = [&](double spacing) {
    const LatticeSpec spec{spacing, Connectivity::twenty_six, scene.free_bounds()->min};
    return std::make_unique<LatticeLevel>(lazy_lattice(scene, spec), false);
  };
  if (lattice) levels_.push_back(std::make_unique<LatticeLevel>(*lattice, true));
  if (scene.free_bounds()) {
    const auto spacings = spacings_for(*scene.free_bounds());
    for (const double spacing : spacings) levels_.push_back(lazy(spacing));
    if (!lattice) guide_ = lazy(kCoarser * spacings[0]);
    for (const double times : {4, 16}) coarse_levels_.push_back(lazy(times * spacings[0]));
  }
}

// As the search gave it, not shortened.
PlanResult Planner::Impl::by_level(LatticeLevel& level, const Task& task) {
  PlanResult result = level.search(scene_, task.from, task.to, guides(task) ? kHaste : 1);
  if (level.given()) require_free(scene_, result.path, "lattice");
  return result;
}

PlanResult Planner::Impl::shortened(PlanResult result, const Task& task) const {
  if (result.path.empty()) return result;
  Found found = refined(scene_, result.path, task.options, true);
  found.expanded = result.expanded;
  return with(std::move(found), OwnRoute::lattice, std::move(result));
}

PlanResult Planner::Impl::by_lattices(const Task& task, std::optional<ReachResult> reached) {
  const auto near = [&](const PlanResult& result) {
    return geom::length(result.path) <= kDetour * task.straight();
  };
  if (guide_ && guides(task)) {
    PlanResult tried = shortened(by_level(*guide_, task), task);
    if (tried.status == PathStatus::found && near(tried)) return tried;
  }
  PlanResult result;
  result.route = OwnRoute::lattice;
  for (const auto& level : levels_) {
    PlanResult tried = shortened(by_level(*level, task), task);
    if (!result.path.empty()) {  // a second opinion on a detour
      return !tried.path.empty() && shorter(tried.path, result.path) ? tried : result;
    }
    result = std::move(tried);
    const bool found = result.status == PathStatus::found;
    if (found && (task.options.raw || near(result))) return result;
    if (found) continue;
    if (result.status == PathStatus::stopped) break;
    if (!reached) reached = reach_.ask(task.from, task.to);
    if (reached->answer == Reachable::no) break;
  }
  if (!result.path.empty()) return result;
  if (result.status == PathStatus::stopped) {
    for (const auto& level : coarse_levels_) {
      PlanResult tried = by_level(*level, task);
      if (tried.status == PathStatus::found) return shortened(std::move(tried), task);
    }
  }
  if (!reached) reached = reach_.ask(task.from, task.to);
  return by_cells(task, std::move(*reached), std::move(result));
}

// What the cells of free space say, once the lattices found no path: `tried` is the last one's.
PlanResult Planner::Impl::by_cells(const Task& task, ReachResult reached, PlanResult tried) const {
  if (reached.answer == Reachable::unknown) {
    tried.message =
        why_not(tried) + "; free space has too many parts to say whether there is a way";
    tried.status = PathStatus::stopped;
    return tried;
  }
  PlanResult result;
  result.route = OwnRoute::cells;
  result.expanded = reached.looked_at;
  if (reached.answer == Reachable::no) {
    result.message = fmt::format("there is no way: obstacles enclose the {}",
                                 reached.from_start ? "start" : "goal");
    if (task.options.keep_cells) {
      result.enclosure = Enclosure{std::move(reached.cells), reached.from_start};
    }
    return result;
  }
  const Polyline way = way_through(reached.cells, task.from, task.to);
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (scene_.free(way[i - 1], way[i])) continue;
    result.status = PathStatus::stopped;
    result.message = fmt::format(
        "there is a way, but it is too narrow for numbers to follow, near {}", shown(way[i]));
    return result;
  }
  Found found = refined(scene_, way, task.options);
  found.expanded = reached.looked_at;
  return with(std::move(found), OwnRoute::cells, {});
}

PlanResult Planner::Impl::by_sampling(const Task& task, SamplingMethod method) {
  const PlanOptions& options = task.options;
  SamplingResult sampled = sample_path(scene_, task.from, task.to, method, options.sampling);
  PlanResult result;
  result.route = method;
  result.expanded = sampled.iterations;
  if (options.keep_tree) result.tree = std::move(sampled.tree);
  if (sampled.found) {
    result.path = std::move(sampled.path);
    result.status = PathStatus::found;
  } else {  // which proves nothing
    result.status = PathStatus::stopped;
    result.message =
        fmt::format("no path found in {}; there may be one: allow more, or take the method auto",
                    geom::counted(sampled.iterations, "iteration"));
  }
  return result;
}

// By one method alone.
PlanResult Planner::Impl::by_method(const Task& task) {
  PlanResult result;
  if (const auto* sampling = std::get_if<SamplingMethod>(&task.options.method)) {
    result = by_sampling(task, *sampling);
  } else {
    result.route = OwnRoute::lattice;
    if (levels_.empty()) return result;
    result = by_level(*levels_[0], task);
    if (result.path.empty()) result.message = why_not(result);
  }
  if (result.path.empty()) return result;
  Found found = refined(scene_, result.path, task.options);
  found.expanded = result.expanded;
  const Route route = *result.route;
  return with(std::move(found), route, std::move(result));
}

// Climb, level flight over all that stands between, and descent, each planned alone: where a box
// hangs over an end, no half-plane has a chain.
std::optional<FirstAnswer> Planner::Impl::by_three_legs(const Task& task) {
  const Vec3 climb = kClimb / task.straight() * (task.to - task.from);
  const auto level = above_all(scene_, task.from + climb, task.to - climb);
  if (!level) return {};
  Polyline path = by_recipe({task.from, level->first, task.options}).path;
  const Polyline descent = by_recipe({level->second, task.to, task.options}).path;
  if (path.empty() || descent.empty()) return {};
  path.insert(path.end(), descent.begin(), descent.end());
  Found found{path, {step_of("search", path)}};
  if (polished(task.options)) {
    found.path = taut(scene_, path);
    found.steps.push_back(step_of("taut", found.path));
  }
  return FirstAnswer{std::move(found), OwnRoute::chain, true};
}

// The shorter of a path found without a search and a lattice's, which is sought where the first may
// be far from shortest.
PlanResult Planner::Impl::first_or_lattices(const Task& task, std::optional<ReachResult> reached) {
  auto first = first_answer(scene_, task);
  if (!first && !task.options.raw && task.straight() >= kFarApart) first = by_three_legs(task);
  PlanResult result;
  const bool given = !levels_.empty() && levels_[0]->given();
  if (given || !first || !suffices(*first, task)) result = by_lattices(task, std::move(reached));
  if (!first || !shorter(first->found.path, result.path)) return result;
  if (polished(task.options) && !first->is_taut) {
    first->found.path = taut(scene_, first->found.path);
    first->found.steps.push_back(step_of("taut", first->found.path));
  }
  return with(std::move(first->found), first->route, {});
}

PlanResult Planner::Impl::by_recipe(const Task& task) {
  if (scene_.free(task.from, task.to)) {
    const Polyline straight = {task.from, task.to};
    return with({straight, {step_of("search", straight)}}, OwnRoute::straight, {});
  }
  std::optional<ReachResult> reached;
  if (bends_.has_roadmap()) {
    auto found = bends_.at_once(task);
    if (!found) {
      reached = reach_.ask(task.from, task.to);
      if (reached->answer == Reachable::no) return by_cells(task, std::move(*reached), {});
      found = bends_.exhaustively(task);
    }
    if (found) {
      if (auto closer = bends_.closer(task, found->path)) found = std::move(closer);
      return with(std::move(*found), OwnRoute::roadmap, {});
    }
  }
  PlanResult result = first_or_lattices(task, std::move(reached));
  if (result.path.empty() || !polished(task.options)) return result;
  auto better = bends_.better(task, result.path);
  if (!better) return result;
  return with(std::move(*better), bends_.has_roadmap() ? OwnRoute::roadmap : OwnRoute::corridor,
              std::move(result));
}

PlanResult Planner::Impl::plan(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  geom::require_point("start", from);
  geom::require_point("goal", to);
  geom::require_length("snap_ends", options.snap_ends, geom::kLargestCoordinate);
  geom::require_length("resample", options.resample, geom::kLargestCoordinate);
  Vec3 ends[] = {from, to};
  std::optional<Vec3> snapped[2];
  for (int i = 0; i < 2; ++i) {
    const Vec3 p = ends[i];
    if (scene_.free(p)) continue;
    const auto free = nearest_free(scene_, p, options.snap_ends);
    if (!free) return refused_end(scene_, p, i == 0);
    snapped[i] = ends[i] = *free;
  }
  const Task task{ends[0], ends[1], options};
  PlanResult result = options.method == kAutomatic ? by_recipe(task) : by_method(task);
  if (options.gap != 0 && !result.path.empty()) {
    BoundOptions bound;
    bound.gap = options.gap;
    bound.keep_proof = options.keep_proof;
    result.bound = bounder_.ask(task.from, task.to, geom::length(result.path), bound);
    if (!result.bound->path.empty() && options.raw) {
      result.bound->closed = false;  // of the path that was found first
    } else if (!result.bound->path.empty()) {
      result.path = result.bound->path;
      result.steps.push_back(step_of("bound", result.path));
    }
  }
  if (options.resample > 0 && !result.path.empty()) {
    result.path = resample_free(scene_, result.path, options.resample);
    result.steps.push_back(step_of("resample", result.path));
  }
  result.snapped_start = snapped[0];
  result.snapped_goal = snapped[1];
  return result;
}

Planner::Planner(const geom::CollisionScene& scene, const Lattice* lattice, const Roadmap* roadmap)
    : impl_(std::make_unique<Impl>(scene, lattice, roadmap)) {}
Planner::~Planner() = default;

PlanResult Planner::plan(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  return impl_->plan(from, to, options);
}

}  // namespace plan
