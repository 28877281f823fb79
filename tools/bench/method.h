#pragma once

// The planners that can be compared, by name.

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "geom/base/execution.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/plan.h"
#include "trial.h"

namespace bench {

struct MethodOptions {
  std::uint64_t seed = 0;
  const plan::Lattice* lattice = nullptr;  // of auto; must outlive the method
  const plan::Roadmap* roadmap = nullptr;
  plan::Quality quality = plan::Quality::normal;
  plan::LatticeSpec spec;         // of astar, but for the spacing
  std::optional<double> spacing;  // metres, of astar's lattice; absent: one that fits the map
  geom::Execution build;          // of what is built before the first query
  double ompl_seconds = 1;
};

// From a query to an answer, one at a time.
struct Method {
  std::function<Answer(const geom::PlanQuery&)> plan;
  std::optional<double> build_seconds;  // wall
};

struct KnownMethod {
  std::string_view name;
  std::function<Method(const geom::CollisionScene& scene, const MethodOptions& options)> make;
};

// Those of plan::kMethodWords, and planners of others.
const std::vector<KnownMethod>& known_methods();

}  // namespace bench
