#include "traj/solve/rung.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Rung, LaterOnesAreLowerAndNamedAsInRecords) {
  EXPECT_LT(Rung::closed, Rung::banded);
  EXPECT_LT(Rung::banded, Rung::ipopt);
  EXPECT_LT(Rung::ipopt, Rung::stop_and_go);
  EXPECT_EQ(name(Rung::closed), "closed");
  EXPECT_EQ(name(Rung::banded), "banded");
  EXPECT_EQ(name(Rung::ipopt), "ipopt");
  EXPECT_EQ(name(Rung::stop_and_go), "stop_and_go");
}

}  // namespace
}  // namespace traj
