#include "solve/step_filter.h"

#include <gtest/gtest.h>

#include <limits>

namespace traj {
namespace {

TEST(StepFilter, TakesLessViolationOrLessOfTheBarrier) {
  StepFilter filter(1);
  EXPECT_TRUE(filter.accepts({1, 10}, {0.5, 20}, -1, 1));
  EXPECT_TRUE(filter.accepts({0.5, 20}, {0.9, 5}, -1, 1));
  EXPECT_FALSE(filter.accepts({0.9, 5}, {0.9, 5}, -1, 1));
  EXPECT_FALSE(filter.accepts({0.9, 5}, {1, 6}, -1, 1));
}

TEST(StepFilter, NeverGoesBackToWhatWasLeftBehind) {
  StepFilter filter(1);
  EXPECT_TRUE(filter.accepts({1, 10}, {0.5, 20}, -1, 1));
  EXPECT_FALSE(filter.accepts({0.5, 20}, {1, 10}, -1, 1));
  filter.forget();
  EXPECT_TRUE(filter.accepts({0.5, 20}, {1, 10}, -1, 1));
}

TEST(StepFilter, AsksTheBarrierToFallOnceThereIsLittleViolation) {
  StepFilter filter(1);
  EXPECT_FALSE(filter.accepts({1e-9, 10}, {0, 10.1}, -1, 1));
  EXPECT_TRUE(filter.accepts({1e-9, 10}, {1e-6, 9.9}, -1, 1));
  EXPECT_TRUE(filter.accepts({1e-9, 10}, {0, 10.1}, 1, 1));  // it was not to fall
}

TEST(StepFilter, RefusesWhatIsFarOffOrNoNumber) {
  StepFilter filter(1);
  EXPECT_FALSE(filter.accepts({1, 10}, {2e4, 0}, -1, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(filter.accepts({1, 10}, {nan, 0}, -1, 1));
  EXPECT_FALSE(filter.accepts({1, 10}, {0, nan}, -1, 1));
}

}  // namespace
}  // namespace traj
