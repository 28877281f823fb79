#include "traj/proof/reason.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Reason, OfALimitIsItsQuantity) {
  for (const LimitKind& kind : kLimitKinds) {
    EXPECT_EQ(name(broken(kind.limit)), kind.quantity);
    EXPECT_EQ(name(unmeasured(kind.limit)), std::string(kind.quantity) + "_not_measured");
  }
}

TEST(Reason, IsNamedAsInReports) {
  EXPECT_EQ(name(Reason::none), "");
  EXPECT_EQ(name(Reason::collision), "collision");
  EXPECT_EQ(name(Reason::return_home), "return");
}

}  // namespace
}  // namespace traj
