#pragma once

// Running one method over a set of queries, against the clock.
//
// Example:
//   plan::bench::QuerySet queries(scene, {.seed = 7});
//   const plan::bench::Method method = plan::bench::known_methods()[0].make(scene, {});
//   double now = 0;
//   const plan::bench::TrialRule rule{.most = 3, .least = 1, .clock = [&] { return now += 1; }};
//   const auto run = plan::bench::measure("mine", method, scene, queries, rule, {});
//   assert(!run.trials.empty());

#include <functional>

#include "plan/bench/method.h"
#include "plan/bench/query_set.h"

namespace plan::bench {

struct TrialRule {
  std::size_t most = 10000;  // trials
  std::size_t least = 100;
  double within = 0.01;    // done when the standard error is at most this share of the mean time
  bool converge = true;    // otherwise `most` trials, or every query of a list
  std::size_t repeat = 1;  // of each query; the median time counts
  // Seconds, from whenever: of the CPU of the calling thread, if other processes shall matter
  // little.
  std::function<double()> clock;
};

// Mean and standard error of numbers that come one by one, by Welford's recurrence.
class RunningMean {
 public:
  void add(double value);
  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  double standard_error() const;  // 0 for fewer than two

 private:
  std::size_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;  // of the deviations from the mean, summed
};

// Times are those of the rule's clock. The first query is run once before, untimed. A list of
// queries is run whole, whatever the rule says of convergence. Progress is reported between trials.
Run measure(const std::string& name, const Method& method, const geom::CollisionScene& scene,
            QuerySet& queries, const TrialRule& rule, const geom::Execution& run);

}  // namespace plan::bench
