#pragma once

// From a query to a path: the default recipe.
//
// Example:
//   plan::Planner planner(scene);
//   const plan::PlanResult result = planner.plan({1, 1, 1}, {9, 1, 1});
//   assert(result.status == geom::PathStatus::found && result.path.size() > 2);  // with bends

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/path_status.h"
#include "geom/text/words.h"
#include "plan/bound/bound.h"
#include "plan/lattice/astar.h"
#include "plan/lattice/lattice.h"
#include "plan/planner/route.h"
#include "plan/reach/reach.h"
#include "plan/roadmap/roadmap.h"
#include "plan/sampling/rrt.h"

namespace plan {

using geom::PathStatus;

enum class Quality {
  fast,    // not pulled taut
  normal,  // pulled taut
  best     // the best of up to 4 paths of a roadmap, each pulled taut, and bends closer together
};

enum class Method {
  automatic,  // as Planner says
  astar,      // A* on the first lattice alone
  rrt,        // this and the next three: the sampling planners of plan/sampling/rrt.h
  rrt_connect,
  rrt_star,
  informed_rrt_star
};
// As on a command line; sampling planners have their own names.
inline constexpr geom::Words<Method, 6> kMethodWords{{
    {Method::automatic, "auto"},
    {Method::astar, "astar"},
    {Method::rrt, name(SamplingMethod::rrt)},
    {Method::rrt_connect, name(SamplingMethod::rrt_connect)},
    {Method::rrt_star, name(SamplingMethod::rrt_star)},
    {Method::informed_rrt_star, name(SamplingMethod::informed_rrt_star)},
}};
constexpr std::string_view name(Method method) { return geom::word_of(kMethodWords, method); }

struct PlanOptions {
  Method method = Method::automatic;
  SamplingOptions sampling;
  bool keep_tree = false;   // of a sampling planner
  bool keep_cells = false;  // that show that there is no way
  bool keep_proof = false;  // of the lower bound
  Quality quality = Quality::normal;
  bool raw = false;     // the search's own path, not shortened
  double resample = 0;  // metres; 0: not
  double gap = 0;  // of a proved lower bound: wanted at length / (1 + gap), 0 < gap <= 1; 0: none
  double snap_ends = 0;  // metres a blocked or outside end may move (nearest_free()); 0: not
};

// What is left of a path after a step: "search", "shortcut", "taut", "bound", "resample", "layer".
struct PathStep {
  std::string_view name;
  std::size_t points = 0;
  double length = 0;  // metres
};

struct PlanResult {
  PathStatus status = PathStatus::unreachable;
  geom::Polyline path;  // start to goal, every leg free; empty unless found
  std::string message;  // why not, in words
  // What gave the path, or what was searched last. Absent where nothing was searched: an end is
  // blocked or outside, or replan() kept a path whole.
  std::optional<Route> route;
  double resolution = 0;     // spacing of the path's lattice, or of the last searched; 0: none was
  std::size_t expanded = 0;  // nodes of that lattice, bends, cells, or iterations of sampling
  std::vector<PathStep> steps;         // from the search to the path
  SearchTree tree;                     // where it was to be kept
  std::optional<Enclosure> enclosure;  // why there is no way, if keep_cells
  std::optional<LengthBound> bound;    // of the path, if a gap was given
  std::optional<Vec3> snapped_start;   // where an end was moved to
  std::optional<Vec3> snapped_goal;
  std::optional<std::pair<double, double>> layer;  // heights it goes in between its ends (layers.h)
};

// The recipe of Method::automatic, in this order:
// 1. The straight line.
// 2. The roadmap, where one is given: up to 8,000 bends from the start on, then 4,000 from the
//    goal on, then, unless Reach says that there is no way, 20,000 from the start on. With a weight
//    of 1.02, but for `best`.
// 3. A* on a lattice, joined to both ends by checked segments; the path is shortened by shortcut().
//    It tries the caller's, if there is one, then 26-connected ones of 10, 5 and 2.5 m (finer on
//    maps too small for these) until one finds a path, each worked out only where the search goes.
//    Where step 4 follows, A* has a weight of 1.02, and shortcut() looks at the path's own points.
//    A shortened path of more than 1.2 times the straight line is compared with the next lattice's.
//    Where a lattice has too many nodes to look at, spacings of 4 and 16 times the first are tried.
//    Once a lattice finds none, Reach says whether there is any way: if not, the goal is
//    unreachable, at no resolution. A way that no lattice finds goes from cell to cell of free
//    space; where it is so narrow that rounding closes it, the search is stopped.
// 4. A* over bends: those of the roadmap where there is one; else those around boxes within 40 m of
//    that path (80 m for `best`), with a weight of 1.03, from point to point of it over stretches
//    of 2 km, each begun in the middle of the one before.
// 5. taut() pulls the result tight.
// Quality::fast leaves out steps 4 and 5. With PlanOptions::gap, a shorter path that the search for
// a bound comes upon is taken, by whichever method the first was found; but not where it was to be
// raw.
//
// An edge of a given lattice or roadmap that is blocked on this map throws geom::InputError. The
// scene and the roadmap must outlive the planner. Threads may plan at once; no answer depends on
// another.
class Planner {
 public:
  explicit Planner(const geom::CollisionScene& scene, const Lattice* lattice = nullptr,
                   const Roadmap* roadmap = nullptr);
  ~Planner();

  PlanResult plan(const Vec3& from, const Vec3& to, const PlanOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
