#include "geom/shape/polyline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(Length, IsTheSumOfTheSegments) {
  EXPECT_EQ(length({}), 0);
  EXPECT_EQ(length({{1, 2, 3}}), 0);
  EXPECT_EQ(length({{0, 0, 0}, {3, 4, 0}, {3, 4, 12}, {3, 4, 12}}), 17);
}

TEST(Resample, CutsEachSegmentIntoTheFewestEqualParts) {
  EXPECT_EQ(resample({{0, 0, 0}, {9, 0, 0}}, 3),
            (Polyline{{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {9, 0, 0}}));
  EXPECT_EQ(resample({{0, 0, 0}, {10, 0, 0}}, 3),
            (Polyline{{0, 0, 0}, {2.5, 0, 0}, {5, 0, 0}, {7.5, 0, 0}, {10, 0, 0}}));
  EXPECT_EQ(resample({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 1, 0}}, 3),
            (Polyline{{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 1, 0}}));
  EXPECT_EQ(resample({{1, 2, 3}}, 3), (Polyline{{1, 2, 3}}));
  EXPECT_EQ(resample({}, 3), Polyline{});
}

TEST(Resample, KeepsPointsBitForBitAndPartsWithinTheStep) {
  support::Random random(1);
  for (int round = 0; round < 200; ++round) {
    Polyline path;
    for (int i = 0; i < 5; ++i) {
      path.push_back({random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(0, 50)});
    }
    const double step = random.uniform(0.1, 30);
    const Polyline fine = resample(path, step);
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      ASSERT_EQ(fine[at], path[i]) << "seed 1, round " << round;
      const double leg = (path[i + 1] - path[i]).norm();
      const auto parts = static_cast<std::size_t>(std::ceil(leg / step));
      for (std::size_t k = 1; k <= parts; ++k) {
        const double part = (fine[at + k] - fine[at + k - 1]).norm();
        ASSERT_NEAR(part, leg / static_cast<double>(parts), 1e-12) << "seed 1, round " << round;
      }
      at += parts;
    }
    ASSERT_EQ(at + 1, fine.size()) << "seed 1, round " << round;
    ASSERT_EQ(fine.back(), path.back()) << "seed 1, round " << round;
  }
}

}  // namespace
}  // namespace geom
