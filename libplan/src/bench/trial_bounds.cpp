#include "plan/bench/trial_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "geom/base/parallel.h"
#include "plan/bound/bound.h"

namespace plan::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Of each query: metres, or kNone.
std::vector<double> shortest_found(const std::vector<Run>& runs) {
  std::size_t most = 0;
  for (const Run& run : runs) most = std::max(most, run.trials.size());
  std::vector<double> shortest(most, kNone);
  for (const Run& run : runs) {
    for (std::size_t i = 0; i < run.trials.size(); ++i) {
      const Trial& trial = run.trials[i];
      if (trial.verdict == Verdict::found) shortest[i] = std::min(shortest[i], trial.length);
    }
  }
  return shortest;
}

}  // namespace

void add_bounds(std::vector<Run>& runs, const geom::CollisionScene& scene, QuerySet& queries,
                double gap, const geom::Execution& run) {
  const std::vector<double> shortest = shortest_found(runs);
  std::vector<geom::PlanQuery> asked;
  for (std::size_t i = 0; i < shortest.size(); ++i) asked.push_back(queries.at(i));
  std::vector<Bound> bounds(shortest.size());
  plan::Bounder bounder(scene);
  plan::BoundOptions options;
  options.gap = gap;
  geom::parallel_for(shortest.size(), run, [&](std::size_t i) {
    if (shortest[i] == kNone) return;
    const auto answer = bounder.ask(asked[i].from, asked[i].to, shortest[i], options);
    if (answer.bound > shortest[i]) {
      throw std::logic_error(
          fmt::format("{}: a path of {} m was found where none under {} m can be", asked[i].id,
                      shortest[i], answer.bound));
    }
    bounds[i] = {answer.bound, answer.closed};
  });
  for (Run& one : runs) {
    for (std::size_t i = 0; i < one.trials.size(); ++i) {
      if (one.trials[i].verdict == Verdict::found) one.trials[i].bound = bounds[i];
    }
  }
}

}  // namespace plan::bench
