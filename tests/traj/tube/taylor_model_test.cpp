#include "tube/taylor_model.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

using std::asin;
using std::cos;
using std::sin;
using std::sqrt;

// Something of all operations, with a value for all arguments in [-1, 1].
template <class S>
S formula(const S& a, const S& b, const S& c) {
  const S root = sqrt(4.0 + a * b + c);
  const S ratio = (a + 2.0 * b) * inverse(root + 1.5);
  return sin(ratio) - cos(a * c) * b + asin(0.4 * c) / root - 3.0 * (a - b);
}

TEST(TaylorModel, HoldsEveryValue) {
  support::Random random(1);
  for (int k = 0; k < 2000; ++k) {
    double middle[3], radius[3];
    TaylorModel m[3];
    for (int i = 0; i < 3; ++i) {
      middle[i] = random.uniform(-0.5, 0.5);
      radius[i] = std::pow(10, random.uniform(-9, -0.4));
      m[i] = TaylorModel::symbol(middle[i], i, radius[i]);
    }
    const TaylorModel all = formula(m[0], m[1], m[2]);
    for (int j = 0; j < 20; ++j) {
      double s[3], at[3];
      for (int i = 0; i < 3; ++i) {
        s[i] = random.uniform(0, 1) < 0.3 ? (random.uniform(0, 1) < 0.5 ? -1 : 1)
                                          : random.uniform(-1, 1);
        at[i] = middle[i] + radius[i] * s[i];
      }
      const double value = formula(at[0], at[1], at[2]);
      const double line = all.c + all.l[0] * s[0] + all.l[1] * s[1] + all.l[2] * s[2];
      EXPECT_LE(std::abs(value - line), all.r);
      EXPECT_GE(value, all.least());
      EXPECT_LE(value, all.most());
    }
  }
}

// The remainder falls with the square of the radius: slopes are right.
TEST(TaylorModel, IsOfTheSecondOrder) {
  const auto remainder = [](double radius) {
    return formula(TaylorModel::symbol(0.1, 0, radius), TaylorModel::symbol(-0.2, 1, radius),
                   TaylorModel::symbol(0.3, 2, radius))
        .r;
  };
  EXPECT_NEAR(remainder(1e-2) / remainder(1e-3), 100, 5);
  EXPECT_LT(remainder(1e-7), 1e-12);
}

TEST(TaylorModel, KnowsNothingOfWhatMayNotBe) {
  const TaylorModel around_zero = TaylorModel::symbol(0.1, 0, 0.2);
  EXPECT_TRUE(std::isinf(inverse(around_zero).r));
  EXPECT_TRUE(std::isinf(sqrt(around_zero).r));
  EXPECT_TRUE(std::isinf(asin(TaylorModel::symbol(0.9, 0, 0.2)).r));
}

TEST(TaylorModel, NamesItsRemainder) {
  const TaylorModel m = TaylorModel::within(2, 0.5).named(7);
  EXPECT_EQ(m.r, 0);
  EXPECT_EQ(m.l[7], 0.5);
  EXPECT_GE(m.most(), 2.5);
}

}  // namespace
}  // namespace traj
