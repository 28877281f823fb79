#include "roadmap/uncovered.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace plan {
namespace {

using Intervals = std::vector<Interval>;

TEST(Uncovered, IsWhatIntervalsLeave) {
  EXPECT_EQ(uncovered(0, 10, {}), (Intervals{{0, 10}}));
  EXPECT_EQ(uncovered(0, 10, {{4, 6}}), (Intervals{{0, 4}, {6, 10}}));
  EXPECT_EQ(uncovered(0, 10, {{6, 20}, {-5, 1}, {0, 2}}), (Intervals{{2, 6}}));
  EXPECT_TRUE(uncovered(0, 10, {{5, 12}, {-1, 5}}).empty());
}

TEST(Uncovered, EndsAtWhatBeginsAfterwards) {
  EXPECT_EQ(uncovered(0, 10, {{12, 20}}), (Intervals{{0, 10}}));
  EXPECT_EQ(uncovered(0, 10, {{-3, -1}}), (Intervals{{0, 10}}));
}

// Beside unit cells, each covered or not.
TEST(Uncovered, LeavesWhatNoIntervalHolds) {
  support::Random random(3);
  for (int n = 0; n < 500; ++n) {
    Intervals covers;
    for (int i = random.below(6); i > 0; --i) {
      const double from = random.below(12) - 1;
      covers.push_back({from, from + 1 + random.below(4)});
    }
    const Intervals left = uncovered(0, 10, covers);
    for (double x = 0.5; x < 10; ++x) {
      const auto holds = [x](const Interval& i) { return i.first < x && x < i.second; };
      EXPECT_EQ(std::count_if(left.begin(), left.end(), holds),
                std::none_of(covers.begin(), covers.end(), holds) ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace plan
