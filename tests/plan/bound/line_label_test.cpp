#include "bound/line_label.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/bound/random_labels.h"

namespace plan {
namespace {

constexpr double kSlack = 1e-12;

using testing::at;
using testing::best_over;
using testing::random_label;
using testing::random_part;

TEST(LineLabel, CarriedToAPointIsTheLeastSum) {
  support::Random random(1);
  for (int i = 0; i < 500; ++i) {
    const EdgePart part = random_part(random, 4);
    const LineLabel label = random_label(random, part);
    const Vec3 q(random.uniform(0, 5), random.uniform(0, 5), random.uniform(0, 5));
    const double best = best_over(part, label, q, 1000);
    EXPECT_LE(carried_to(part, label, q), best + 1e-12);
    EXPECT_GT(carried_to(part, label, q), best - 1e-3 * part.length() - 1e-12);
  }
}

TEST(LineLabel, CarriedIsNowhereAboveTheLeastSum) {
  support::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const EdgePart from = random_part(random, 4);
    const EdgePart to = random_part(random, 4);
    const LineLabel label = random_label(random, from);
    const double d = least_distance(from, to);
    const LineLabel by = carried(from, label, to, d, kSlack);
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      ASSERT_LE(at(by, t), best_over(from, label, at(to, t), 1000) + 1e-12);
    }
    EXPECT_GE(by.least(), label.least() + 0.5 * d - 2 * kSlack);
  }
}

TEST(LineLabel, CarriedOverNoDistanceLosesNothing) {
  const EdgePart x{{0, 0, 0}, {1, 0, 0}, 0, {1, 1}};
  const EdgePart y{{1, 0, 0}, {1, 1, 0}, 1, {1, 1}};
  const LineLabel by = carried(x, {5, 4.5}, y, 0, 1e-3);
  EXPECT_EQ(by, (LineLabel{4.5, 4.5}));
}

TEST(LineLabel, LeastDistanceIsThatOfTheClosestPoints) {
  support::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const EdgePart a = random_part(random, 4);
    const EdgePart b = random_part(random, 4);
    double best = std::numeric_limits<double>::infinity();
    for (int n = 0; n <= 100; ++n)
      best = std::min(best, best_over(b, {0, 0}, at(a, 0.01 * n), 1000));
    EXPECT_LE(least_distance(a, b), best);
    EXPECT_GT(least_distance(a, b), best - 0.05);
  }
}

}  // namespace
}  // namespace plan
