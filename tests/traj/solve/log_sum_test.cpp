// libtraj/src/solve/log_sum.h against the C library.

#include "solve/log_sum.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(LogSum, IsTheSumOfTheLogarithms) {
  testing::Random random(1);
  LogSum sum;
  EXPECT_EQ(sum.value(), 0);
  double want = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = std::exp(random.number(-300, 300));
    sum.add(x);
    want += std::log(x);
    EXPECT_NEAR(sum.value(), want, 1e-11 * (1 + std::abs(want))) << i;
  }
}

TEST(LogSum, IsExactOfOneAndNearOneToItsRounding) {
  LogSum one;
  one.add(1);
  EXPECT_EQ(one.value(), 0);
  one.add(1 + 1e-8);
  EXPECT_NEAR(one.value(), 1e-8, 1e-15);
}

TEST(LogSum, IsNoNumberOfWhatHasNoLogarithm) {
  for (const double x : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    LogSum sum;
    sum.add(2);
    sum.add(x);
    sum.add(3);
    EXPECT_TRUE(std::isnan(sum.value())) << x;
  }
}

}  // namespace
}  // namespace traj
