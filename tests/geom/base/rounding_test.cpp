#include "geom/base/rounding.h"

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include <random>

namespace geom {
namespace {

using Q = CGAL::Gmpq;

// Of every size, with neighbours of round numbers among them.
double draw(std::mt19937& random) {
  const int exponent = std::uniform_int_distribution(-40, 40)(random);
  const double x = std::ldexp(std::uniform_real_distribution(-2.0, 2.0)(random), exponent);
  switch (random() % 4) {
    case 0:
      return std::round(x);
    case 1:
      return next_up(std::round(x) + (x < 0 ? -1 : 1));
    default:
      return x;
  }
}

// Whether `up` and `down` are the doubles around the real number, or both that number.
void expect_around(double down, double up, const Q& real) {
  ASSERT_LE(Q(down), real);
  ASSERT_GE(Q(up), real);
  if (Q(down) == real || Q(up) == real) {
    ASSERT_EQ(down, up);
  } else {
    ASSERT_EQ(next_up(down), up);
  }
}

TEST(Rounding, SumsAreTheDoublesAroundTheRealSum) {
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) {
    const double a = draw(random);
    const double b = draw(random);
    SCOPED_TRACE(i);
    expect_around(add_down(a, b), add_up(a, b), Q(a) + Q(b));
  }
}

TEST(Rounding, ProductsAreTheDoublesAroundTheRealProduct) {
  std::mt19937 random(12);
  for (int i = 0; i < 20000; ++i) {
    const double a = draw(random);
    const double b = draw(random);
    SCOPED_TRACE(i);
    expect_around(multiply_down(a, b), multiply_up(a, b), Q(a) * Q(b));
  }
}

TEST(Rounding, FloatsLieOnTheirSideAndNoFloatLiesBetween) {
  std::mt19937 random(13);
  for (int i = 0; i < 20000; ++i) {
    const double x = draw(random);
    const float up = float_up(x);
    const float down = float_down(x);
    ASSERT_GE(up, x) << x;
    ASSERT_LE(down, x) << x;
    ASSERT_TRUE(up == down || std::nextafter(down, up) == up) << x;
  }
}

TEST(Rounding, AnUlpIsTheStepToTheNextLargerMagnitude) {
  EXPECT_EQ(ulp(1), 0x1p-52);
  EXPECT_EQ(ulp(-1), 0x1p-52);
  EXPECT_EQ(ulp(next_down(1.0)), 0x1p-53);
  EXPECT_EQ(ulp(0), std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace geom
