#include "geom/import/synth_city.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

TEST(SynthCity, IsTheSameForASeedAndAnotherForAnother) {
  const auto a = synth_city({1});
  const auto b = synth_city({1});
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
    return x.center == y.center && x.half == y.half;
  }));
  EXPECT_NE(a.size(), synth_city({2}).size());
}

TEST(SynthCity, HasAtLeast3000BoxesThatStandInsideIts900Metres) {
  const auto boxes = synth_city({0});
  EXPECT_GE(boxes.size(), 3000u);
  for (const auto& box : boxes) {
    EXPECT_GT(box.half.minCoeff(), 0);
    EXPECT_GE(box.center.z() - box.half.z(), -1e-9);
    EXPECT_LE(box.center.cwiseAbs().head<2>().maxCoeff(), 450);
    EXPECT_LE(box.center.z() + box.half.z(), 230);
  }
}

TEST(SynthCity, CountsInMillimetresAndFillsTheAreaAskedFor) {
  const auto boxes = synth_city({3, 2000, 600, 80});
  EXPECT_NEAR(static_cast<double>(boxes.size()), 4 * 2000 * 600 / 1000.0, 2000);
  double farthest = 0;
  for (const auto& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      const double low = 1000 * (box.center[k] - box.half[k]);
      ASSERT_NEAR(low, std::round(low), 1e-6);
    }
    farthest = std::max(farthest, std::abs(box.center.x()));
    EXPECT_LE(std::abs(box.center.y()), 300);
  }
  EXPECT_GT(farthest, 800);
  EXPECT_LE(farthest, 1000);
}

}  // namespace
}  // namespace geom
