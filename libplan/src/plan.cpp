#include "plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "geom/error.h"
#include "plan/build_lattice.h"
#include "plan/shortcut.h"
#include "plan/snap_end.h"
#include "plan/taut.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr std::int64_t kRings = 4;     // of nodes around an end that may be joined to it
constexpr double kSpacing = 10;        // metres: of the first lattice on a map of a city's size
constexpr int kLevels = 3;             // each of half the spacing of the one before
constexpr double kMostNodes = 0x1p25;  // of a lattice built here: 0.7 GB with one workspace
constexpr double kWholeMap = 0x1p19;   // nodes at kSpacing: beyond, regions are searched
constexpr double kRegion = 150;        // metres around the ends, at first
constexpr double kFewestNodes = 1e4;   // of the first lattice: a small map gets a finer one
constexpr double kDetour = 1.2;        // of the straight line: then a finer lattice may know better
constexpr double kLookAround = 50;     // metres: how far a message looks for a free place

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
  while (nodes_at(inner, first) > kMostNodes) first *= 2;
  for (int i = 0; i < 10 && nodes_at(inner, first) < kFewestNodes; ++i) first /= 2;
  std::vector<double> spacings = {first};
  while (spacings.size() < kLevels && nodes_at(inner, spacings.back() / 2) <= kMostNodes) {
    spacings.push_back(spacings.back() / 2);
  }
  return spacings;
}

enum class Rings { nearest, all };

// Free nodes that see `p`, in the rings of nodes around it: those of the nearest ring that has any,
// or of all. Ring 0 is the corners of the cell around `p`.
std::vector<Terminal> visible_nodes(const geom::CollisionScene& scene, const Lattice& lattice,
                                    const Vec3& p, Rings rings) {
  Index3 base;
  for (int k = 0; k < 3; ++k) {
    const double cells = std::floor((p[k] - lattice.coordinate(k, 0)) / lattice.spec().spacing);
    base[k] = std::clamp(static_cast<std::int64_t>(cells), std::int64_t{-1}, lattice.dims()[k]);
  }
  std::vector<Terminal> found;
  for (std::int64_t ring = 0; ring <= kRings; ++ring) {
    if (rings == Rings::nearest && !found.empty()) break;
    for (std::int64_t k = -ring; k <= ring + 1; ++k) {
      for (std::int64_t j = -ring; j <= ring + 1; ++j) {
        for (std::int64_t i = -ring; i <= ring + 1; ++i) {
          const auto on_edge = [&](std::int64_t v) { return v == -ring || v == ring + 1; };
          if (!on_edge(i) && !on_edge(j) && !on_edge(k)) continue;
          const auto node = lattice.node({base[0] + i, base[1] + j, base[2] + k});
          if (!node || !lattice.free(*node)) continue;
          const Vec3 q = lattice.position(*node);
          if (scene.free(p, q)) found.push_back({*node, (q - p).norm()});
        }
      }
    }
  }
  return found;
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

Polyline joined(const Lattice& lattice, const Vec3& from, const std::vector<std::size_t>& nodes,
                const Vec3& to) {
  Polyline path = {from};
  for (const std::size_t node : nodes) path.push_back(lattice.position(node));
  path.push_back(to);
  path.erase(std::unique(path.begin(), path.end()), path.end());
  if (path.size() == 1) path.push_back(to);
  return path;
}

}  // namespace

std::string_view name(PlanStatus status) {
  switch (status) {
    case PlanStatus::found:
      return "found";
    case PlanStatus::unreachable:
      return "unreachable";
    case PlanStatus::start_blocked:
      return "start_blocked";
    case PlanStatus::goal_blocked:
      return "goal_blocked";
    case PlanStatus::start_outside:
      return "start_outside";
    case PlanStatus::goal_outside:
      return "goal_outside";
  }
  return "";
}

// A lattice, given or built when first needed, and workspaces for those who search on it.
struct Planner::Level {
  const Lattice* given = nullptr;
  double spacing = 0;
  std::optional<geom::Aabb> within;
  std::once_flag once;
  std::optional<Lattice> built;
  std::mutex mutex;
  std::vector<std::unique_ptr<AstarSearch>> idle;

  const Lattice& lattice(const geom::CollisionScene& scene, const geom::Execution& run) {
    if (given) return *given;
    std::call_once(once, [&] {
      built = build_lattice(scene, {spacing, Connectivity::twenty_six, scene.free_bounds()->min},
                            {run.threads, {}}, within);
    });
    return *built;
  }

  std::unique_ptr<AstarSearch> take(const Lattice& lattice) {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return std::make_unique<AstarSearch>(lattice);
    auto search = std::move(idle.back());
    idle.pop_back();
    return search;
  }

  void give_back(std::unique_ptr<AstarSearch> search) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(search));
  }
};

Planner::Planner(const geom::CollisionScene& scene, const Lattice* lattice, geom::Execution run,
                 const Roadmap* roadmap)
    : scene_(scene), run_(std::move(run)), roadmap_(roadmap) {
  const auto add = [&](double spacing) {
    levels_.push_back(std::make_unique<Level>());
    levels_.back()->spacing = spacing;
    levels_.back()->given = lattice;
  };
  if (lattice) {
    add(lattice->spec().spacing);
  } else if (scene.free_bounds() && nodes_at(*scene.free_bounds(), kSpacing) <= kWholeMap) {
    for (const double spacing : spacings_for(*scene.free_bounds())) add(spacing);
  }
}

Planner::~Planner() = default;

bool Planner::search_level(Level& level, const Vec3& from, const Vec3& to, PlanResult& result) {
  const Lattice& lattice = level.lattice(scene_, run_);
  result.resolution = lattice.spec().spacing;
  result.expanded = 0;
  auto search = level.take(lattice);
  SearchResult found;
  // The nearest nodes may lie in a pocket that the lattice cannot leave, though the end itself can.
  for (const Rings rings : {Rings::nearest, Rings::all}) {
    found = search->search(visible_nodes(scene_, lattice, from, rings),
                           visible_nodes(scene_, lattice, to, rings));
    result.expanded += found.expanded;
    if (found.found) break;
  }
  level.give_back(std::move(search));
  if (!found.found) return false;
  result.path = joined(lattice, from, found.nodes, to);
  if (level.given) require_free(scene_, result.path, "lattice");
  return true;
}

PlanResult Planner::search_levels(const Levels& levels, const Vec3& from, const Vec3& to,
                                  const PlanOptions& options) {
  PlanResult result;
  const double straight = (to - from).norm();
  for (const auto& level : levels) {
    PlanResult tried;
    const bool found = search_level(*level, from, to, tried);
    if (found && !options.raw) tried.path = shortcut(scene_, tried.path);
    if (found && polished(options)) tried.path = taut(scene_, tried.path);
    if (!result.path.empty()) {  // a second opinion on a detour
      if (found && geom::length(tried.path) < geom::length(result.path)) result = std::move(tried);
      return result;
    }
    result = std::move(tried);
    if (found && (options.raw || geom::length(result.path) <= kDetour * straight)) return result;
  }
  return result;
}

bool Planner::search_roadmap(const Vec3& from, const Vec3& to, const PlanOptions& options,
                             PlanResult& result) {
  std::unique_ptr<RoadmapSearch> search;
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      search = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!search) search = std::make_unique<RoadmapSearch>(scene_, *roadmap_);
  RoadmapLimits limits;
  if (options.quality == Quality::best) limits = {limits.settled, 40, 0.02};
  const RoadmapResult found = search->search(from, to, limits);
  {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(search));
  }
  result.expanded = found.settled;
  for (const Polyline& raw : found.paths) {
    require_free(scene_, raw, "roadmap");
    Polyline path = polished(options) ? taut(scene_, raw) : raw;
    if (result.path.empty() || geom::length(path) < geom::length(result.path)) {
      result.path = std::move(path);
    }
  }
  return !result.path.empty();
}

// A path of length l stays within sqrt(l^2 - d^2) / 2 of the straight line of length d sideways and
// (l - d) / 2 beyond its ends, which is less.
PlanResult Planner::search_regions(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  const geom::Aabb all = *scene_.free_bounds();
  const double straight = (to - from).norm();
  PlanResult best;
  for (double pad = std::max(kRegion, straight / 4);;) {
    const Vec3 around(pad, pad, all.max.z() - all.min.z());
    const geom::Aabb region{(from.cwiseMin(to) - around).cwiseMax(all.min),
                            (from.cwiseMax(to) + around).cwiseMin(all.max)};
    Levels levels;
    for (const double spacing : spacings_for(region)) {
      levels.push_back(std::make_unique<Level>());
      levels.back()->spacing = spacing;
      levels.back()->within = region;
    }
    PlanResult tried = search_levels(levels, from, to, options);
    const bool found = !tried.path.empty();
    if (!best.path.empty()) {
      return found && geom::length(tried.path) < geom::length(best.path) ? tried : best;
    }
    best = std::move(tried);
    if (region.min == all.min && region.max == all.max) return best;
    pad *= 4;
    if (!found) continue;
    const double length = geom::length(best.path);
    const double needed = std::sqrt(std::max(0.0, length * length - straight * straight)) / 2;
    if (length <= kDetour * straight || needed <= pad / 4) return best;
    pad = needed;
  }
}

PlanResult Planner::search(const Vec3& from, const Vec3& to, const PlanOptions& options) {
  PlanResult result;
  if (scene_.free(from, to)) {
    result.method = "straight";
    result.path = {from, to};
  } else if (roadmap_ && search_roadmap(from, to, options, result)) {
    result.method = "roadmap";
  } else {
    result = levels_.empty() ? search_regions(from, to, options)
                             : search_levels(levels_, from, to, options);
    result.method = "lattice";
    if (result.path.empty()) {
      result.message = fmt::format("no path on a lattice of {} m", result.resolution);
      return result;
    }
  }
  if (options.resample > 0) result.path = resample_free(scene_, result.path, options.resample);
  result.status = PlanStatus::found;
  return result;
}

PlanResult Planner::plan(const Vec3& from, const Vec3& to, const PlanOptions& options) {
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
    result.status = i == 0 ? (outside ? PlanStatus::start_outside : PlanStatus::start_blocked)
                           : (outside ? PlanStatus::goal_outside : PlanStatus::goal_blocked);
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
  PlanResult result = search(ends[0], ends[1], options);
  result.snapped_start = snapped[0];
  result.snapped_goal = snapped[1];
  return result;
}

}  // namespace plan
