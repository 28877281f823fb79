#pragma once

// The planners that can be compared, by name.
//
// Example:
//   for (const plan::bench::KnownMethod& known : plan::bench::known_methods()) {
//     std::cout << known.name << '\n';
//   }
//   const auto first = plan::bench::known_methods()[0].make(scene, {.seed = 7});

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "geom/base/execution.h"
#include "plan/bench/trial.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/plan.h"

namespace plan::bench {

struct MethodOptions {
  std::uint64_t seed = 0;
  const plan::Lattice* lattice = nullptr;  // of auto; must outlive the method
  const plan::Roadmap* roadmap = nullptr;
  plan::Quality quality = plan::Quality::normal;
  plan::LatticeSpec spec;         // of astar, but for the spacing
  std::optional<double> spacing;  // metres, of astar's lattice; absent: one that fits the map
  geom::Execution build;          // of what is built before the first query
  double seconds = 1;             // for a query, of planners that go on until their time is over
};

// From a query to an answer, one at a time.
using Method = std::function<Answer(const geom::PlanQuery&)>;

struct KnownMethod {
  std::string_view name;
  std::function<Method(const geom::CollisionScene& scene, const MethodOptions& options)> make;
  bool builds = false;  // much, before the first query
};

// Those of plan::kMethodWords.
const std::vector<KnownMethod>& known_methods();

}  // namespace plan::bench
