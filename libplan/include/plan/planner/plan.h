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
#include <variant>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/path_status.h"
#include "geom/record/search_report.h"
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
using geom::PathStep;

enum class Quality {
  fast,    // the first path, not pulled taut
  normal,  // searched for among bends, and pulled taut
  best     // among bends closer together; over up to 2 km the best of 4 paths, each pulled taut
};

inline constexpr geom::Words<Quality, 3> kQualityWords{{
    {Quality::fast, "fast"},
    {Quality::normal, "normal"},
    {Quality::best, "best"},
}};

enum class OwnMethod {
  automatic,  // as Planner says
  astar       // A* on the first lattice alone
};
inline constexpr geom::Words<OwnMethod, 2> kOwnMethodWords{{
    {OwnMethod::automatic, "auto"},
    {OwnMethod::astar, "astar"},
}};

// How a path is searched for: also by each of the sampling planners (plan/sampling/rrt.h), without
// a line here.
using Method = std::variant<OwnMethod, SamplingMethod>;
inline constexpr Method kAutomatic = OwnMethod::automatic;
inline constexpr Method kAstar = OwnMethod::astar;
// As on a command line.
inline constexpr auto kMethodWords = geom::joined<Method>(kOwnMethodWords, kSamplingWords);
constexpr std::string_view name(Method method) { return geom::word_of(kMethodWords, method); }

struct PlanOptions {
  Method method = kAutomatic;
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

// The recipe of kAutomatic, in this order:
// 1. The straight line.
// 2. The roadmap, where one is given: up to 8,000 bends from the start on, then 4,000 from the
//    goal on, then, unless Reach says that there is no way, 20,000 from the start on. With a weight
//    of 1.02, but for `best`.
// 3. A chain over or round what stands on the straight line, within half a plane: the shortest of
//    up to seven, pulled taut. Where there is none over 1,500 m and more, as from under a roof: a
//    climb over 300 m by these steps, level flight over all that stands between, and a descent.
// 4. A* on a lattice, joined to both ends by checked segments; the path is shortened by shortcut().
//    It tries the caller's, if there is one, then 26-connected ones of 20 (where step 5 follows),
//    10, 5 and 2.5 m (finer on maps too small for these) until one finds a path, each worked out
//    only where the search goes. Where step 5 follows, A* has a weight of 1.1, and shortcut() looks
//    at the path's own points. A shortened path of more than 1.2 times the straight line is
//    compared with the next lattice's. Where a lattice has too many nodes to look at, spacings of 4
//    and 16 times the first are tried. Once a lattice finds none, Reach says whether there is any
//    way: if not, the goal is unreachable, at no resolution. A way that no lattice finds goes from
//    cell to cell of free space; where it is so narrow that rounding closes it, the search is
//    stopped. Without a lattice of the caller's the step is left out where the chain is at
//    most 1.01 times the straight line, or 1.2 times over 1,500 m and more.
// 5. A* over bends, for a path shorter than the shortest of these: over those of the roadmap where
//    there is one; else over all that such a path may use, around up to 6,000 boxes, or else around
//    those within 40 m (80 m for `best`) of the path that is known. The weight is 1.05 (1.01 for
//    `best`). A path of more than 2 km is looked at in stretches of 2 km, each begun in the middle
//    of the one before; a stretch within 0.02 % of its straight line stays.
// 6. taut() pulls the result tight.
// Quality::fast leaves out steps 4 to 6, and takes the shorter of the chain and the shortest of
// four of RRT-Connect where the chain is more than twice as long as the straight line (below 1,500
// m); where it has neither, it takes step 4. PlanOptions::raw leaves out steps 3, 5 and 6. With
// PlanOptions::gap, a shorter path that the search for a bound comes upon is taken, by whichever
// method the first was found; but not where it was to be raw.
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
