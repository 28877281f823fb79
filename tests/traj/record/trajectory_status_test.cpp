#include "traj/record/trajectory_status.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(TrajectoryStatus, SaysWhyThereIsNothingToCheck) {
  EXPECT_EQ(reason_of(TrajectoryStatus::solved), Reason::none);
  EXPECT_EQ(reason_of(TrajectoryStatus::no_path), Reason::no_path);
  EXPECT_EQ(reason_of(TrajectoryStatus::infeasible), Reason::infeasible);
  EXPECT_EQ(reason_of(TrajectoryStatus::stopped), Reason::stopped);
}

}  // namespace
}  // namespace traj
