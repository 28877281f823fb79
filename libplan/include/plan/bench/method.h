#pragma once

// The planners that can be compared, by name.
//
//   const auto& known = plan::bench::known_methods().front();
//   const plan::bench::Method method = known.make(scene, {.seed = 7});

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

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
  const char* name;
  Method (*make)(const geom::CollisionScene& scene, const MethodOptions& options);
  bool builds = false;  // much, before the first query
};

// Those of this library. A new one is a line in this table.
std::span<const KnownMethod> known_methods();

}  // namespace plan::bench
