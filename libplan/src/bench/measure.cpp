#include "plan/bench/measure.h"

#include <algorithm>
#include <cmath>

namespace plan::bench {
namespace {

struct Timed {
  Answer answer;
  double seconds = 0;
};

Timed median_of(const TrialRule& rule, const Method& method, const geom::PlanQuery& query) {
  Timed timed;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < rule.repeat; ++i) {
    const double begin = rule.clock();
    Answer answer = method(query);
    seconds.push_back(rule.clock() - begin);
    if (i == 0) timed.answer = std::move(answer);
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>((rule.repeat - 1) / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  timed.seconds = *middle;
  return timed;
}

}  // namespace

void RunningMean::add(double value) {
  ++count_;
  const double from_old = value - mean_;
  mean_ += from_old / static_cast<double>(count_);
  squares_ += from_old * (value - mean_);
}

double RunningMean::standard_error() const {
  if (count_ < 2) return 0;
  const auto n = static_cast<double>(count_);
  return std::sqrt(squares_ / (n - 1) / n);
}

Run measure(const std::string& name, const Method& method, const geom::CollisionScene& scene,
            QuerySet& queries, const TrialRule& rule, const geom::Execution& run) {
  const std::size_t most = queries.size().value_or(rule.most);
  const bool converge = rule.converge && !queries.size();
  Run result;
  result.method = name;
  method(queries.at(0));
  RunningMean time;
  if (converge) result.converged = false;
  while (result.trials.size() < most && !result.converged.value_or(false)) {
    const geom::PlanQuery& query = queries.at(result.trials.size());
    const Timed timed = median_of(rule, method, query);
    result.trials.push_back(trial_of(scene, query, timed.answer, timed.seconds));
    time.add(timed.seconds);
    if (run.progress) run.progress(time.count(), most);
    if (converge && time.count() >= std::max<std::size_t>(rule.least, 2)) {
      result.converged = time.standard_error() <= rule.within * time.mean();
    }
  }
  if (run.progress && result.trials.size() < most) {
    run.progress(result.trials.size(), result.trials.size());
  }
  return result;
}

}  // namespace plan::bench
