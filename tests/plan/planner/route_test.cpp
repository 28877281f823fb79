#include "plan/planner/route.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

// Records carry these words: to rename one is to change the format.
TEST(Route, IsNamedAsInRecords) {
  EXPECT_EQ(name(Route::straight), "straight");
  EXPECT_EQ(name(Route::roadmap), "roadmap");
  EXPECT_EQ(name(Route::corridor), "corridor");
  EXPECT_EQ(name(Route::lattice), "lattice");
  EXPECT_EQ(name(Route::rrt), "rrt");
  EXPECT_EQ(name(Route::rrt_connect), "rrt-connect");
  EXPECT_EQ(name(Route::rrt_star), "rrt-star");
  EXPECT_EQ(name(Route::informed_rrt_star), "informed-rrt-star");
}

}  // namespace
}  // namespace plan
