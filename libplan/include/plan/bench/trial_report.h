#pragma once

// What came of the trials, in numbers and as a table.
//
// Example:
//   plan::bench::Run run{.method = "mine"};
//   run.trials.push_back({.verdict = plan::bench::Verdict::found, .seconds = 0.1, .length = 9});
//   std::cout << plan::bench::table({{run}});

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "plan/bench/trial.h"

namespace plan::bench {

// How a run compares with another on the same queries: the ratio of the mean times, and the mean
// ratio of the lengths over the queries that both found.
struct Comparison {
  double time = 0;
  std::optional<double> length;  // nothing where there is no such query
  std::size_t queries = 0;
};

// Over the queries that both ran; of processes timed as a whole, over all.
Comparison compare(const Run& run, const Run& first);

nlohmann::ordered_json counts(const Run& run);  // nothing that depends on the clock

nlohmann::ordered_json report(const Run& run, const Run& first);

// One row a run, the first being what the others are compared with.
std::string table(std::span<const Run> runs);

}  // namespace plan::bench
