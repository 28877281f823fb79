#include "geom/figure/ticks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_city.h"

namespace {

using support::Random;

TEST(TicksProperty, AreRoundWithinTheRangeAndNeitherFewNorMany) {
  Random random(31);
  for (int i = 0; i < 2000; ++i) {
    const double low = random.uniform(-1, 1) * std::pow(10, random.uniform(-3, 4));
    const double high = low + std::pow(10, random.uniform(-2, 6));
    const auto ticks = geom::figure::ticks(low, high, 4);
    SCOPED_TRACE(testing::Message() << "seed 31, case " << i << ": " << low << " to " << high);
    ASSERT_GE(ticks.size(), 2u);
    ASSERT_LE(ticks.size(), 7u);
    const double step = ticks[1] - ticks[0];
    EXPECT_GE(ticks.front(), low - 1e-6 * step);
    EXPECT_LE(ticks.back(), high + 1e-6 * step);
    const double lead = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    EXPECT_LT(std::min({std::abs(lead - 1), std::abs(lead - 2), std::abs(lead - 5)}), 1e-6);
  }
}

}  // namespace
