#include "plan/bench/trial_report.h"

#include <gtest/gtest.h>

namespace plan::bench {
namespace {

Trial trial(Verdict verdict, double seconds, double length) {
  return {verdict, seconds, length, 1, std::nullopt, std::nullopt};
}

TEST(Compare, LooksAtTheQueriesThatBothRanAndBothFound) {
  bench::Run first;
  first.trials = {trial(Verdict::found, 1, 10), trial(Verdict::failed, 3, 0),
                  trial(Verdict::found, 2, 10)};
  bench::Run run;
  run.trials = {trial(Verdict::found, 4, 12), trial(Verdict::found, 4, 50)};
  const Comparison against = compare(run, first);
  EXPECT_DOUBLE_EQ(against.time, 2);
  EXPECT_DOUBLE_EQ(against.length.value(), 1.2);
  EXPECT_EQ(against.queries, 1u);
}

}  // namespace
}  // namespace plan::bench
