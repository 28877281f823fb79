#include "map/sdf_interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shape/exact_sum.h"
#include "support/cases.h"
#include "support/exact_oracle.h"

namespace geom {
namespace {

using oracle::Q;

// Low and high in rationals.
Q low_of(const SdfInterval& i) { return Q(i.place) + Q(i.offset) - Q(i.length) / 2; }
Q high_of(const SdfInterval& i) { return Q(i.place) + Q(i.offset) + Q(i.length) / 2; }

TEST(SdfInterval, IsPlainWhereThatWillDo) {
  const SdfInterval i = sdf_interval(1, 4);
  EXPECT_EQ(i.place, 2.5);
  EXPECT_EQ(i.offset, 0);
  EXPECT_EQ(i.length, 3);
  EXPECT_TRUE(i.same);
  EXPECT_EQ(sdf_interval(7, 7).length, 0);
}

// Ends of sizes that share few digits, of few digits, and powers of two.
std::pair<double, double> some_ends(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto some = [&] {
    const double v = std::ldexp(share(random), static_cast<int>(random() % 60) - 33);
    return random() % 4 == 0 ? std::round(v * 1000) / 1000 : v;
  };
  const double low = some();
  double high = some();
  if (random() % 4 == 0) high = -low;
  if (random() % 8 == 0) high = std::exp2(static_cast<int>(random() % 20));
  return std::minmax(low, high);
}

TEST(SdfInterval, RoundsOutwardToWhatItWas) {
  std::mt19937_64 random(1);
  for (int k = 0; k < support::cases(50000); ++k) {
    const auto [low, high] = some_ends(random);
    const SdfInterval i = sdf_interval(low, high);
    if (!i.same) {
      ASSERT_TRUE(low < 0 && high > 0) << "case " << k << ' ' << low << ' ' << high;
      ASSERT_LE(low_of(i), Q(low)) << "case " << k;
      ASSERT_GE(high_of(i), Q(high)) << "case " << k;
      ASSERT_LE(Q(i.length) - (Q(high) - Q(low)), Q(8e-16) * Q(high - low)) << "case " << k;
      continue;
    }
    ASSERT_GE(low_of(i), Q(low)) << "case " << k;
    ASSERT_LT(low_of(i), Q(std::nextafter(low, 1e300))) << "case " << k;
    ASSERT_LE(high_of(i), Q(high)) << "case " << k;
    ASSERT_GT(high_of(i), Q(std::nextafter(high, -1e300))) << "case " << k;
  }
}

// Of a middle and a length, each in one double, what is read is written so that it is read again.
TEST(SdfInterval, KeepsWhatWasRead) {
  std::mt19937_64 random(2);
  for (int k = 0; k < support::cases(50000); ++k) {
    const auto [middle, end] = some_ends(random);
    const double length = std::abs(end);
    ExactSum low;
    low.add(middle);
    low.add(-0.5 * length);
    ExactSum high;
    high.add(middle);
    high.add(0.5 * length);
    ASSERT_TRUE(sdf_interval(low.down(), high.up()).same) << "case " << k << ' ' << middle;
  }
}

}  // namespace
}  // namespace geom
