#include "shape/exact_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geom/base/rounding.h"
#include "support/cases.h"
#include "support/exact_oracle.h"

namespace geom {
namespace {

using oracle::Q;

TEST(ExactSum, OfNothingIsZero) {
  EXPECT_EQ(ExactSum().down(), 0);
  EXPECT_EQ(ExactSum().up(), 0);
  EXPECT_FALSE(std::signbit(ExactSum().up()));
  EXPECT_EQ(ExactSum().sign(), 0);
}

TEST(ExactSum, RoundsOnce) {
  ExactSum sum;
  sum.add(1);
  sum.add(1e-30);
  EXPECT_EQ(sum.down(), 1);
  EXPECT_EQ(sum.up(), next_up(1));
  sum.add(-1);
  EXPECT_EQ(sum.down(), 1e-30);
  EXPECT_EQ(sum.up(), 1e-30);
}

// Sizes that lose most of their digits to each other.
TEST(ExactSum, IsTheNeighbourOfTheSumInRationals) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (int k = 0; k < support::cases(20000); ++k) {
    ExactSum sum;
    Q exact = 0;
    const int count = static_cast<int>(random() % ExactSum::kMost) + 1;
    for (int i = 0; i < count; ++i) {
      double term = std::ldexp(mantissa(random), static_cast<int>(random() % 160) - 110);
      if (random() % 3 == 0) term = std::round(term);
      if (random() % 5 == 0) term = -sum.down();
      sum.add(term);
      exact += Q(term);
    }
    ASSERT_LE(Q(sum.down()), exact) << "case " << k;
    ASSERT_GT(Q(next_up(sum.down())), exact) << "case " << k;
    ASSERT_GE(Q(sum.up()), exact) << "case " << k;
    ASSERT_LT(Q(next_down(sum.up())), exact) << "case " << k;
    ASSERT_EQ(sum.sign(), exact.sign()) << "case " << k;
  }
}

}  // namespace
}  // namespace geom
