#include "geom/figure/histogram.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"

namespace {

using support::Random;

TEST(Histogram, HoldsEachValueOnceInRoundBins) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> values;
    const double scale = std::pow(10, random.uniform(-3, 5));
    for (int k = random.below(50); k >= 0; --k) values.push_back(scale * random.uniform(-1, 3));
    const geom::figure::Histogram bars = geom::figure::histogram(values, 40);
    SCOPED_TRACE(testing::Message() << "seed 5, case " << i);
    std::size_t all = 0;
    for (const std::size_t count : bars.counts) all += count;
    EXPECT_EQ(all, values.size());
    EXPECT_LE(bars.counts.size(), 43u);
    for (const double v : values) {
      EXPECT_GE(v, bars.low - 1e-9 * scale);
      EXPECT_LE(v, bars.high() + 1e-9 * scale);
    }
  }
}

TEST(Histogram, OfEqualValuesOrNoneIsOneBin) {
  EXPECT_EQ(geom::figure::histogram({}, 40).counts, std::vector<std::size_t>{0});
  const std::vector<double> zeros(7, 0.0);
  EXPECT_EQ(geom::figure::histogram(zeros, 40).counts, std::vector<std::size_t>{7});
}

}  // namespace
