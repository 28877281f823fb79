#pragma once

// A step on the way to a path: what is asked of it, and what it gives.

#include <string_view>
#include <vector>

#include "geom/collision/collision.h"
#include "plan/planner/plan.h"

namespace plan {

// What is asked, once both ends are free.
struct Task {
  Vec3 from;
  Vec3 to;
  const PlanOptions& options;

  double straight() const { return (to - from).norm(); }
};

// A path that a step of the recipe found, and how it came about.
struct Found {
  geom::Polyline path;
  std::vector<PathStep> steps;
  std::size_t expanded = 0;
};

// Of the name of a step, and the path after it.
PathStep step_of(std::string_view name, const geom::Polyline& path);

// Any path is shorter than none.
bool shorter(const geom::Polyline& path, const geom::Polyline& than);

// Whether paths are pulled taut.
bool polished(const PlanOptions& options);

// Throws geom::InputError, naming `source`, where an edge that was read is not free.
void require_free(const geom::CollisionScene& scene, const geom::Polyline& path,
                  const char* source);

// What a search found, shortened as the options say; less thoroughly where it `leads` to bends.
Found refined(const geom::CollisionScene& scene, const geom::Polyline& raw,
              const PlanOptions& options, bool leads = false);

}  // namespace plan
