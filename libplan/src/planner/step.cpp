#include "step.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "path/shortcut.h"
#include "path/taut.h"
#include "shown_point.h"

namespace plan {

using geom::Polyline;

PathStep step_of(std::string_view name, const Polyline& path) {
  return {name, path.size(), geom::length(path)};
}

bool shorter(const Polyline& path, const Polyline& than) {
  return than.empty() || geom::length(path) < geom::length(than);
}

bool polished(const PlanOptions& options) {
  return !options.raw && options.quality != Quality::fast;
}

void require_free(const geom::CollisionScene& scene, const Polyline& path, const char* source) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (scene.free(path[i - 1], path[i])) continue;
    throw geom::InputError(source,
                           {.says = fmt::format("the edge from {} to {} is blocked on this map",
                                                shown(path[i - 1]), shown(path[i])),
                            .advice = "make the file again for it"});
  }
}

Found refined(const geom::CollisionScene& scene, const Polyline& raw, const PlanOptions& options,
              bool leads) {
  Found found{raw, {step_of("search", raw)}};
  if (options.raw) return found;
  const bool once = leads && polished(options);
  found.path = once ? shortcut(scene, found.path, 0) : shortcut(scene, found.path);
  found.steps.push_back(step_of("shortcut", found.path));
  if (!polished(options)) return found;
  found.path = taut(scene, found.path);
  found.steps.push_back(step_of("taut", found.path));
  return found;
}

}  // namespace plan
