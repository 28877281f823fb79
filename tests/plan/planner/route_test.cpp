#include "plan/planner/route.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

// Records carry these words: to rename one is to change the format.
TEST(Route, IsNamedAsInRecords) {
  EXPECT_EQ(name(OwnRoute::straight), "straight");
  EXPECT_EQ(name(OwnRoute::roadmap), "roadmap");
  EXPECT_EQ(name(OwnRoute::corridor), "corridor");
  EXPECT_EQ(name(OwnRoute::lattice), "lattice");
  EXPECT_EQ(name(SamplingMethod::rrt), "rrt");
  EXPECT_EQ(name(SamplingMethod::rrt_connect), "rrt-connect");
  EXPECT_EQ(name(SamplingMethod::rrt_star), "rrt-star");
  EXPECT_EQ(name(SamplingMethod::informed_rrt_star), "informed-rrt-star");
}

}  // namespace
}  // namespace plan
