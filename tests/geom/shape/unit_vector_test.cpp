#include "shape/unit_vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geom {
namespace {

TEST(UnitVector, IsTheSineAndCosine) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-1000, 1000);
  for (int k = 0; k < 100000; ++k) {
    const double a = k < 50000 ? angle(random) : angle(random) / 200;
    const UnitVector v = unit_vector(a);
    ASSERT_LE(std::abs(v.cosine - std::cos(static_cast<long double>(a))), 2e-16L) << a;
    ASSERT_LE(std::abs(v.sine - std::sin(static_cast<long double>(a))), 2e-16L) << a;
  }
}

TEST(UnitVector, OfDegreesIsExactAtQuarters) {
  for (int k = -8; k <= 8; ++k) {
    const UnitVector v = unit_vector_of_degrees(90.0 * k);
    EXPECT_EQ(std::abs(v.cosine), k % 2 == 0 ? 1 : 0) << k;
    EXPECT_EQ(std::abs(v.sine), k % 2 == 0 ? 0 : 1) << k;
    EXPECT_EQ(v.cosine + v.sine,
              std::round(std::cos(k * std::acos(0.0)) + std::sin(k * std::acos(0.0))));
  }
  EXPECT_NEAR(unit_vector_of_degrees(-30).sine, -0.5, 2e-16);
  EXPECT_NEAR(unit_vector_of_degrees(57000.25).cosine, std::cos(57000.25L * std::acos(-1.0L) / 180),
              2e-16);
}

TEST(UnitVector, DividesAHalfTurn) {
  for (const std::size_t n : {1u, 2u, 3u, 8u, 1001u}) {
    const auto around = round_half_turn(n);
    ASSERT_EQ(around.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      const long double a =
          std::acos(-1.0L) * static_cast<long double>(i) / static_cast<long double>(n);
      EXPECT_NEAR(around[i].cosine, std::cos(a), 2e-16) << n << ' ' << i;
      EXPECT_NEAR(around[i].sine, std::sin(a), 2e-16) << n << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace geom
