#include "plan/planner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "lattice/ring.h"
#include "lattice_level.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/shortcut.h"
#include "plan/planner/snap_end.h"
#include "plan/planner/taut.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr double kSpacing = 10;       // metres: of the first lattice on a map of a city's size
constexpr int kLevels = 3;            // each of half the spacing of the one before
constexpr double kFewestNodes = 1e4;  // of the first lattice: a small map gets a finer one
constexpr double kDetour = 1.2;       // of the straight line: then a finer lattice may know better
constexpr double kCorridor = 40;      // metres beside a lattice's path that bends are sought in
constexpr double kClose = 4;          // metres beside a path that bends are sought in more closely
constexpr double kClosePart = 3;      // metres: how closely
constexpr double kCloseMost = 150;  // metres between ends: beyond, bends are close enough as it is
constexpr std::size_t kPaths = 4;   // compared once pulled taut
constexpr double kBend = 10;  // metres that bends in the middle of their parts may cost a path
constexpr double kCorridorReach = 300;        // metres
constexpr std::size_t kUnknownBends = 4000;   // settled where it is not known that there is a way
constexpr std::size_t kCorridorBends = 3000;  // settled at most
constexpr double kLookAround = 50;            // metres: how far a message looks for a free place

std::string shown(const Vec3& p) { return fmt::format("({}, {}, {})", p[0], p[1], p[2]); }

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

// What was read may say what it likes of its edges.
void require_free(const geom::CollisionScene& scene, const Polyline& path, const char* source) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (scene.free(path[i - 1], path[i])) continue;
    throw geom::InputError(source, fmt::format("the edge from {} to {} is blocked on this map",
                                               shown(path[i - 1]), shown(path[i])));
  }
}

bool polished(const PlanOptions& options) {
  return !options.raw && options.quality != Quality::fast;
}

PathStep step_of(std::string_view name, const Polyline& path) {
  return {name, path.size(), geom::length(path)};
}

std::string why_not(const PlanResult& result) {
  return fmt::format("{} on a lattice of {} m",
                     result.status == PathStatus::stopped ? "too many nodes" : "no path",
                     result.resolution);
}

SamplingMethod sampling(Method method) {
  switch (method) {
    case Method::rrt_connect:
      return SamplingMethod::rrt_connect;
    case Method::rrt_star:
      return SamplingMethod::rrt_star;
    case Method::informed_rrt_star:
      return SamplingMethod::informed_rrt_star;
    default:
      return SamplingMethod::rrt;
  }
}

}  // namespace

struct Planner::Impl {
  Impl(const geom::CollisionScene& scene, const Lattice* lattice, const Roadmap* roadmap);

  PlanResult plan(const Vec3& from, const Vec3& to, const PlanOptions& options);

  PlanResult search(const Vec3& from, const Vec3& to, const PlanOptions& options);
  std::uint32_t component(const Vec3& p) const;
  RoadmapLimits first_limits(const Vec3& from, const Vec3& to) const;
  bool improve(RoadmapSearch& search, const Vec3& from, const Vec3& to, const PlanOptions& options,
               RoadmapLimits limits, PlanResult& result);
  bool search_roadmap(const Vec3& from, const Vec3& to, const PlanOptions& options,
                      const RoadmapLimits& limits, PlanResult& result);
  void search_closely(const Vec3& from, const Vec3& to, const PlanOptions& options,
                      PlanResult& result);
  bool search_corridor(const Vec3& from, const Vec3& to, const PlanOptions& options,
                       PlanResult& result);
  PlanResult search_levels(const Vec3& from, const Vec3& to, const PlanOptions& options);
  bool search_level(LatticeLevel& level, const Vec3& from, const Vec3& to, PlanResult& result);
  PlanResult search_as_asked(const Vec3& from, const Vec3& to, const PlanOptions& options);
  void refine(const PlanOptions& options, PlanResult& result) const;

  const geom::CollisionScene& scene_;
  const Roadmap* roadmap_;
  std::mutex mutex_;  // guards the workspaces
  std::vector<std::unique_ptr<RoadmapSearch>> idle_;
  std::vector<std::unique_ptr<LatticeLevel>> levels_;         // from the first to try to finer ones
  std::vector<std::unique_ptr<LatticeLevel>> coarse_levels_;  // for where the first are too large
};

std::string_view name(Method method) {
  switch (method) {
    case Method::automatic:
      return "auto";
    case Method::astar:
      return "astar";
    default:
      return name(sampling(method));
  }
}

Planner::Impl::Impl(const geom::CollisionScene& scene, const Lattice* lattice,
                    const Roadmap* roadmap)
    : scene_(scene), roadmap_(roadmap) {
  const auto lazy = [&](double spacing) {
    const LatticeSpec spec{spacing, Connectivity::twenty_six, scene.free_bounds()->min};
    return std::make_unique<LatticeLevel>(lazy_lattice(scene, spec), false);
  };
  if (lattice) {
    levels_.push_back(std::make_unique<LatticeLevel>(*lattice, true));
  } else if (scene.free_bounds()) {
    const auto spacings = spacings_for(*scene.free_bounds());
    for (const double spacing : spacings) levels_.push_back(lazy(spacing));
    for (const double times : {4, 16}) coarse_levels_.push_back(lazy(times * spacings[0]));
  }
}

// Whether there is a path on this lattice.
bool Planner::Impl::search_level(LatticeLevel& level, const Vec3& from, const Vec3& to,
                                 PlanResult& result) {
  if (!level.search(scene_, from, to, result)) return false;
  if (level.given()) require_free(scene_, result.path, "lattice");
  return true;
}

PlanResult Planner::Impl::search_levels(const Vec3& from, const Vec3& to,
                                        const PlanOptions& options) {
  PlanResult result;
  const double straight = (to - from).norm();
  for (const auto& level : levels_) {
    PlanResult tried;
    const bool found = search_level(*level, from, to, tried);
    if (found) refine(options, tried);
    if (!result.path.empty()) {  // a second opinion on a detour
      if (found && geom::length(tried.path) < geom::length(result.path)) result = std::move(tried);
      return result;
    }
    result = std::move(tried);
    if (found && (options.raw || geom::length(result.path) <= kDetour * straight)) return result;
    if (result.status == PathStatus::stopped) break;
  }
  if (result.status != PathStatus::stopped) return result;
  for (const auto& level : coarse_levels_) {
    PlanResult tried;
    if (!search_level(*level, from, to, tried)) continue;
    refine(options, tried);
    return tried;
  }
  return result;
}

// The component of the coarse lattice that a point sees; 0 where it sees none.
std::uint32_t Planner::Impl::component(const Vec3& p) const {
  const LabelledLattice& coarse = *roadmap_->coarse;
  std::uint32_t found = 0;
  const auto sees = [&](const Index3& index) {
    const std::size_t node = *coarse.lattice.node(index);
    found = coarse.label[node];
    return found != 0 && scene_.free(p, coarse.lattice.position(node));
  };
  for (const std::int64_t ring : {0, 1}) {
    if (any_in_ring(coarse.lattice, p, ring, sees)) return found;
  }
  return 0;
}

// How far to search the roadmap before the lattices were asked, which know sooner that there is no
// way.
RoadmapLimits Planner::Impl::first_limits(const Vec3& from, const Vec3& to) const {
  if (!roadmap_->coarse) return {};
  const std::uint32_t a = component(from);
  const std::uint32_t b = component(to);
  if (a == 0 || b == 0) return {kUnknownBends};
  return a == b ? RoadmapLimits{} : RoadmapLimits{0};
}

// The shortest of the roadmap's paths, where it is shorter than what there is.
bool Planner::Impl::improve(RoadmapSearch& search, const Vec3& from, const Vec3& to,
                            const PlanOptions& options, RoadmapLimits limits, PlanResult& result) {
  if (options.quality == Quality::best) {
    limits.paths = kPaths;
    limits.beyond = kBend / (to - from).norm();
  }
  const RoadmapResult found = search.search(from, to, limits);
  bool better = false;
  for (const Polyline& raw : found.paths) {
    require_free(scene_, raw, "roadmap");
    PlanResult tried;
    tried.path = raw;
    tried.steps = {step_of("search", raw)};
    if (polished(options)) {
      tried.path = taut(scene_, raw);
      tried.steps.push_back(step_of("taut", tried.path));
    }
    if (!result.path.empty() && geom::length(tried.path) >= geom::length(result.path)) continue;
    result.path = std::move(tried.path);
    result.steps = std::move(tried.steps);
    result.expanded = found.settled;
    better = true;
  }
  return better;
}

// With bends closer to each other along the path that there is.
void Planner::Impl::search_closely(const Vec3& from, const Vec3& to, const PlanOptions& options,
                                   PlanResult& result) {
  const Roadmap close = bends_along(scene_, {kClosePart, kCorridorReach, {}}, result.path, kClose);
  RoadmapSearch search(scene_, close);
  improve(search, from, to, options, {kCorridorBends}, result);
}

bool Planner::Impl::search_roadmap(const Vec3& from, const Vec3& to, const PlanOptions& options,
                                   const RoadmapLimits& limits, PlanResult& result) {
  if (limits.settled == 0) return false;
  std::unique_ptr<RoadmapSearch> search;
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      search = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!search) search = std::make_unique<RoadmapSearch>(scene_, *roadmap_);
  const bool better = improve(*search, from, to, options, limits, result);
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(search));
  return better;
}

// Bends around the boxes near a path that a lattice gave.
bool Planner::Impl::search_corridor(const Vec3& from, const Vec3& to, const PlanOptions& options,
                                    PlanResult& result) {
  const Roadmap corridor =
      bends_along(scene_, {10, kCorridorReach, {}}, result.path,
                  options.quality == Quality::best ? 2 * kCorridor : kCorridor);
  RoadmapSearch search(scene_, corridor);
  RoadmapLimits limits{kCorridorBends};
  limits.weight = (to - from).norm() < 1000 ? 1.02 : 1.04;
  return improve(search, from, to, options, limits, result);
}

// Shortens what a search found.
void Planner::Impl::refine(const PlanOptions& options, PlanResult& result) const {
  result.steps = {step_of("search", result.path)};
  if (options.raw) return;
  result.path = shortcut(scene_, result.path);
  result.steps.push_back(step_of("shortcut", result.path));
  if (!polished(options)) return;
  result.path = taut(scene_, result.path);
  result.steps.push_back(step_of("taut", result.path));
}

// By one method alone.
PlanResult Planner::Impl::search_as_asked(const Vec3& from, const Vec3& to,
                                          const PlanOptions& options) {
  PlanResult result;
  bool found = false;
  if (options.method == Method::astar) {
    result.route = Route::lattice;
    if (levels_.empty()) return result;
    found = search_level(*levels_[0], from, to, result);
    if (!found) result.message = why_not(result);
  } else {
    SamplingResult sampled =
        sample_path(scene_, from, to, sampling(options.method), options.sampling);
    found = sampled.found;
    result.route = geom::value_of(kRouteWords, name(options.method));
    result.path = std::move(sampled.path);
    result.expanded = sampled.iterations;
    if (options.keep_tree) result.tree = std::move(sampled.tree);
    if (!found) {  // which proves nothing
      result.status = PathStatus::stopped;
      result.message = fmt::format("no path after {} iterations", sampled.iterations);
    }
  }
  if (!found) return result;
  result.status = PathStatus::found;
  refine(options, result);
  return result;
}

PlanResult Planner::Impl::search(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  PlanResult result;
  if (scene_.free(from, to)) {
    result.route = Route::straight;
    result.path = {from, to};
    result.steps = {step_of("search", result.path)};
    result.status = PathStatus::found;
    return result;
  }
  if (roadmap_ && search_roadmap(from, to, options, first_limits(from, to), result)) {
    result.route = Route::roadmap;
    result.status = PathStatus::found;
    if (options.quality == Quality::best && (to - from).norm() < kCloseMost) {
      search_closely(from, to, options, result);
    }
    return result;
  }
  result = search_levels(from, to, options);
  result.route = Route::lattice;
  if (result.path.empty()) {
    result.message = why_not(result);
    return result;
  }
  result.status = PathStatus::found;
  if (!polished(options)) return result;
  if (roadmap_ ? search_roadmap(from, to, options, {kCorridorBends}, result)
               : search_corridor(from, to, options, result)) {
    result.route = roadmap_ ? Route::roadmap : Route::corridor;
  }
  return result;
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
    const bool outside = !scene_.inside_bounds(p);
    const char* const end = i == 0 ? "start" : "goal";
    const auto free = nearest_free(scene_, p, std::max(options.snap_ends, kLookAround));
    if (free && (*free - p).norm() <= options.snap_ends) {
      snapped[i] = ends[i] = *free;
      continue;
    }
    PlanResult result;
    result.status = i == 0 ? (outside ? PathStatus::start_outside : PathStatus::start_blocked)
                           : (outside ? PathStatus::goal_outside : PathStatus::goal_blocked);
    std::string what = "outside the bounds";
    if (!outside) {
      const auto boxes = scene_.boxes_meeting({p, p});
      what = fmt::format("inside obstacle {}", scene_.map().ids()[boxes.front()]);
    }
    result.message = fmt::format("{} {} is {}; ", end, shown(p), what);
    result.message +=
        free ? fmt::format("the nearest free point is {:.3f} m away", (*free - p).norm())
             : fmt::format("no free point within {} m", kLookAround);
    return result;
  }
  PlanResult result = options.method == Method::automatic
                          ? search(ends[0], ends[1], options)
                          : search_as_asked(ends[0], ends[1], options);
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
