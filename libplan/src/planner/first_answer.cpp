#include "first_answer.h"

#include "path/shortcut.h"
#include "path/taut.h"
#include "seed/first_path.h"
#include "seed/tree_path.h"

namespace plan {
namespace {

// Times the straight line.
constexpr double kEnough = 1.0002;    // then no other chain is looked for
constexpr double kFastEnough = 1.05;  // and for `fast`
constexpr double kLong = 2;           // beyond, trees may know better
constexpr double kNear = 1.01;        // then lattices are not asked
constexpr double kNearOverFar = 1.2;  // nor then, where they would take long

Found shortened(const geom::CollisionScene& scene, const geom::Polyline& path, bool fast) {
  Found found{path, {step_of("search", path)}};
  found.path = fast ? shortcut(scene, path, 0) : taut(scene, path);
  found.steps.push_back(step_of(fast ? "shortcut" : "taut", found.path));
  return found;
}

}  // namespace

std::optional<FirstAnswer> first_answer(const geom::CollisionScene& scene, const Task& task) {
  if (task.options.raw) return {};
  const bool fast = !polished(task.options);
  FirstAnswer first{{}, OwnRoute::chain};
  geom::Polyline path = first_path(scene, task.from, task.to, fast ? kFastEnough : kEnough);
  if (fast && task.straight() < kFarApart &&
      (path.empty() || geom::length(path) > kLong * task.straight())) {
    geom::Polyline tree = tree_path(scene, task.from, task.to);
    if (!tree.empty() && shorter(tree, path)) {
      path = std::move(tree);
      first.route = SamplingMethod::rrt_connect;
    }
  }
  if (path.empty()) return {};
  first.found = shortened(scene, path, fast);
  return first;
}

bool suffices(const FirstAnswer& first, const Task& task) {
  if (!polished(task.options)) return true;
  const double straight = task.straight();
  return geom::length(first.found.path) <=
         (straight >= kFarApart ? kNearOverFar : kNear) * straight;
}

}  // namespace plan
