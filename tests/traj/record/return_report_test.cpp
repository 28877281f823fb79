#include "traj/record/return_report.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(ReturnReport, SharesTheTimeOutsideOfGaps) {
  ReturnReport report{.duration = 100};
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.share(), 1);
  report.gaps.push_back({.from = 10, .until = 20});
  report.gaps.push_back({.from = 50, .until = 65});
  EXPECT_FALSE(report.ok());
  EXPECT_EQ(report.share(), 0.75);
}

// An instant alone is refused, though it takes no time.
TEST(ReturnReport, IsRefusedByAGapOfOneInstant) {
  ReturnReport report{.duration = 100};
  report.gaps.push_back({.from = 10, .until = 10});
  EXPECT_FALSE(report.ok());
  EXPECT_EQ(report.share(), 1);
}

TEST(ReturnReport, OfAFlightWithoutDuration) {
  ReturnReport report;
  EXPECT_EQ(report.share(), 1);
  report.gaps.push_back({});
  EXPECT_EQ(report.share(), 0);
}

}  // namespace
}  // namespace traj
