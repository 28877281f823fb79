#include "plan/bench/measure.h"

#include <gtest/gtest.h>

#include "support/walled_scene.h"

namespace plan::bench {
namespace {

using support::kAcross;

const geom::CollisionScene& scene() { return support::walled_scene(); }

// A clock of which each look takes a second.
std::function<double()> ticking() {
  return [seconds = 0.0]() mutable { return ++seconds; };
}

TEST(RunningMean, IsThatOfTheTextbook) {
  RunningMean mean;
  for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) mean.add(value);
  EXPECT_DOUBLE_EQ(mean.mean(), 5);
  EXPECT_DOUBLE_EQ(mean.standard_error(), std::sqrt(32.0 / 7 / 8));
}

TEST(Measure, StopsAtTheLeastTrialsWhereTheRuleHolds) {
  QuerySet set(scene(), {});
  const Method method = [](const geom::PlanQuery&) {
    return Answer{geom::PathStatus::unreachable, {}, {}};
  };
  TrialRule rule;
  rule.clock = ticking();
  rule.least = 10;
  rule.within = 1;  // always: no standard error of times is more than their mean
  const bench::Run run = measure("none", method, scene(), set, rule, {});
  EXPECT_EQ(run.trials.size(), 10u);
  EXPECT_TRUE(run.converged.value());
  EXPECT_EQ(count(run, Verdict::unreachable), 10u);
  rule.converge = false;
  rule.most = 20;
  EXPECT_EQ(measure("none", method, scene(), set, rule, {}).trials.size(), 20u);
}

TEST(Measure, RunsAListWhole) {
  QuerySet list({kAcross, kAcross});
  const Method method = [](const geom::PlanQuery&) { return Answer{}; };
  const bench::Run run = measure("none", method, scene(), list, {.clock = ticking()}, {});
  EXPECT_EQ(run.trials.size(), 2u);
  EXPECT_FALSE(run.converged);
  EXPECT_EQ(run.trials[0].best_known, 120);
}

}  // namespace
}  // namespace plan::bench
