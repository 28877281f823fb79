#include "first_answer.h"

#include "path/shortcut.h"
#include "path/taut.h"
#include "seed/first_path.h"
#include "seed/tree_path.h"

namespace plan {
namespace {

// Times the straight line.
constexpr double kEnough = 1.0002;    // then no other chain is looked for
constexpr double kHopeless = 1.1;     // over a distance: then a lattice will know better
constexpr double kFastEnough = 1.05;  // and for `fast`
constexpr double kLong = 2;           // beyond, trees may know better
constexpr double kNear = 1.01;        // then lattices are not asked
constexpr double kNearOverFar = 1.2;  // nor then, where they would take long

Found shortened(const geom::CollisionScene& scene, const geom::Polyline& path, bool pull) {
  Found found{path, {step_of("search", path)}};
  found.path = pull ? taut(scene, path) : shortcut(scene, path, 0);
  found.steps.push_back(step_of(pull ? "taut" : "shortcut", found.path));
  return found;
}

}  // namespace

std::optional<FirstAnswer> first_answer(const geom::CollisionScene& scene, const Task& task) {
  if (task.options.raw) return {};
  const bool fast = !polished(task.options);
  FirstAnswer first{{}, OwnRoute::chain};
  const double straight = task.straight();
  FirstPathLimits limits{fast ? kFastEnough : kEnough};
  if (!fast) limits.hopeless = kHopeless;
  geom::Polyline path = first_path(scene, task.from, task.to, limits);
  if (fast && straight < kFarApart && (path.empty() || geom::length(path) > kLong * straight)) {
    geom::Polyline tree = tree_path(scene, task.from, task.to);
    if (!tree.empty() && shorter(tree, path)) {
      path = std::move(tree);
      first.route = SamplingMethod::rrt_connect;
    }
  }
  if (path.empty()) return {};
  const bool hopeless = straight > kFarChain && geom::length(path) > kHopeless * straight;
  first.is_taut = !fast && !hopeless;
  first.found = shortened(scene, path, first.is_taut);
  return first;
}

bool suffices(const FirstAnswer& first, const Task& task) {
  if (!polished(task.options)) return true;
  const double straight = task.straight();
  return geom::length(first.found.path) <=
         (straight >= kFarApart ? kNearOverFar : kNear) * straight;
}

}  // namespace plan
