#include "traj/proof/limits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace traj {
namespace {

TEST(OrderOfLimits, HasEachLimitOnce) {
  for (const LimitKind& kind : kLimitKinds) {
    EXPECT_EQ(std::count(kOrderOfLimits.begin(), kOrderOfLimits.end(), kind.limit), 1) << kind.name;
  }
}

}  // namespace
}  // namespace traj
