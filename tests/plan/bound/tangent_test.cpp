#include "bound/tangent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_city.h"

namespace plan {
namespace {

constexpr double kSlack = 1e-12;

EdgePart random_part(support::Random& random, double size) {
  EdgePart part;
  for (int k = 0; k < 3; ++k) part.low[k] = random.stepped(0, size, 0.5);
  part.high = part.low;
  const int axis = random.below(4);
  if (axis == 3) return part;
  part.axis = static_cast<std::uint8_t>(axis);
  part.high[axis] += random.stepped(0.25, 3, 0.25);
  part.outward = {1, 1};
  return part;
}

LineLabel random_label(support::Random& random, const EdgePart& part) {
  const double low = random.uniform(0, 10);
  return {low, low + random.uniform(-1, 1) * part.length()};
}

Vec3 at(const EdgePart& part, double t) { return part.low + t * (part.high - part.low); }

double at(const LineLabel& label, double t) { return label.low * (1 - t) + label.high * t; }

double best_over(const EdgePart& part, const LineLabel& label, const Vec3& q) {
  double best = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= 200; ++n) {
    best = std::min(best, at(label, 5e-3 * n) + (q - at(part, 5e-3 * n)).norm());
  }
  return best;
}

TEST(Tangent, IsNowhereAboveTheLeastSum) {
  support::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double size = i % 2 ? 4 : 700;
    const EdgePart from = random_part(random, size);
    const EdgePart to = random_part(random, size);
    const Tangent between = tangent(from, to, kSlack);
    const LineLabel here = random_label(random, from);
    const LineLabel there = random_label(random, to);
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      ASSERT_LE(at(between.forward(here), t), best_over(from, here, at(to, t)) + 1e-12);
      ASSERT_LE(at(between.backward(there), t), best_over(to, there, at(from, t)) + 1e-12);
    }
  }
}

TEST(Tangent, OfPlacesIsTheDistance) {
  const EdgePart a{{1, 2, 3}, {1, 2, 3}, kCorner, {}};
  const EdgePart b{{4, 6, 3}, {4, 6, 3}, kCorner, {}};
  const LineLabel by = tangent(a, b, kSlack).forward({7, 7});
  EXPECT_NEAR(by.low, 12, 1e-6);
  EXPECT_EQ(by.low, by.high);
  EXPECT_LE(by.low, 12);
  EXPECT_LE(tangent(a, a, kSlack).forward({7, 7}).low, 7);
}

TEST(Tangent, TouchesWhereTheWayIsBetweenMiddles) {
  const EdgePart a{{0, 0, -2}, {0, 0, 2}, 2, {1, 1}};
  const EdgePart b{{30, 40, -3}, {30, 40, 3}, 2, {1, 1}};
  const LineLabel by = tangent(a, b, kSlack).forward({5, 5});
  EXPECT_NEAR(by.low, 55, 1e-4);
  EXPECT_NEAR(by.high, 55, 1e-4);
}

TEST(Tangent, FollowsTheSlopeOfTheWay) {
  const EdgePart a{{0, 0, 0}, {0, 0, 0}, kCorner, {}};
  const EdgePart b{{3, 0, 3}, {3, 0, 5}, 2, {1, 1}};  // the middle is 5 away, 0.8 of it along z
  const LineLabel by = tangent(a, b, kSlack).forward({1, 1});
  EXPECT_NEAR(by.low, 6 - 0.8, 1e-5);
  EXPECT_NEAR(by.high, 6 + 0.8, 1e-5);
  const LineLabel back = tangent(a, b, kSlack).backward({1, 1});
  EXPECT_NEAR(back.low, 6 - 0.8, 1e-5);
}

}  // namespace
}  // namespace plan
