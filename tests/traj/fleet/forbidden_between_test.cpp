#include "fleet/forbidden_between.h"

#include <gtest/gtest.h>

#include "traj/fleet/random_flights.h"
#include "traj/together/pair_check.h"

namespace traj {
namespace {

using testing::forbidden_departures;
using testing::holds;
using testing::least_share;
using testing::random_flight;
using testing::steady;

constexpr double kForEver = std::numeric_limits<double>::infinity();

const std::vector<Zone> kZones{cylinder(5, 2)};

TEST(ForbiddenBetween, OfTwoThatCross) {
  const auto spans = forbidden_departures(steady({-100, 0, 0}, {100, 0, 0}),
                                          steady({0, -100, 0}, {0, 100, 0}), kZones, Parked::gone);
  // At difference d they are |10 d| / sqrt 2 apart when nearest.
  ASSERT_EQ(spans.size(), 1u);
  const double most = 5 * std::sqrt(2.0) / 10;
  EXPECT_LE(spans[0].low, -most);
  EXPECT_GE(spans[0].high, most);
  EXPECT_NEAR(spans[0].low, -most, 0.03);
  EXPECT_NEAR(spans[0].high, most, 0.03);
}

TEST(ForbiddenBetween, NoneForThoseOnOtherHeights) {
  EXPECT_TRUE(forbidden_departures(steady({-100, 0, 0}, {100, 0, 0}),
                                   steady({0, -100, 2.1}, {0, 100, 2.1}), kZones, Parked::gone)
                  .empty());
}

TEST(ForbiddenBetween, OneAfterTheOtherOnTheSameWay) {
  const Trajectory flight = steady({-100, 0, 0}, {100, 0, 0});
  const auto spans = forbidden_departures(flight, flight, kZones, Parked::gone);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].low, -0.5, 0.02);
  EXPECT_NEAR(spans[0].high, 0.5, 0.02);
}

TEST(ForbiddenBetween, StandingInTheWayHasNoEnd) {
  const Trajectory flight = steady({-100, 0, 0}, {100, 0, 0});
  const Trajectory away = steady({0, 0, 0}, {0, 200, 0});  // stands in the way until it departs
  const auto spans = forbidden_departures(flight, away, kZones, Parked::pad);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].high, kForEver);
  const double least = 10 - std::sqrt(0.5);  // it leaves northward when the other is 7 m before it
  EXPECT_LE(spans[0].low, least);
  EXPECT_NEAR(spans[0].low, least, 0.02);
  EXPECT_LE(forbidden_departures(flight, away, kZones, Parked::gone)[0].high, 10.6);
}

TEST(ForbiddenBetween, TheSamePadForAllTimeIsNever) {
  const auto spans = forbidden_departures(steady({0, 0, 0}, {200, 0, 0}),
                                          steady({0, 0, 0}, {-200, 0, 0}), kZones, Parked::pad);
  EXPECT_EQ(spans, (std::vector<DepartureSpan>{{-kForEver, kForEver}}));
}

TEST(ForbiddenBetween, AreCutToTheWindow) {
  const Trajectory flight = steady({-100, 0, 0}, {100, 0, 0});
  const auto spans = forbidden_departures(flight, flight, kZones, Parked::gone, {0.1, 0.2});
  EXPECT_EQ(spans, (std::vector<DepartureSpan>{{0.1, 0.2}}));
  EXPECT_TRUE(forbidden_departures(flight, flight, kZones, Parked::gone, {1, 2}).empty());
}

// Every difference that samples find too near is in the set, and the exact check of pairs proves
// every difference beside it. What is in it and not too near is within a little of the zone.
TEST(ForbiddenBetween, AgreeWithSamplesAndWithTheProof) {
  geom::SplitMix64 random(4);
  int free = 0;
  int taken = 0;
  for (int k = 0; k < 120; ++k) {
    const Trajectory a = random_flight(random, 60, 10);
    const Trajectory b = random_flight(random, 60, 10);
    const Zone zone = random.chance(0.5) ? cylinder(random.uniform(2, 15), random.uniform(1, 5))
                                         : Zone{false, {random.uniform(2, 9), 4, 2}};
    const Parked parked = random.chance(0.5) ? Parked::pad : Parked::gone;
    const std::vector<Zone> zones{zone};
    const auto spans = forbidden_departures(a, b, zones, parked);
    for (int i = 0; i < 40; ++i) {
      const double d = random.uniform(-duration(b) - 10, duration(a) + 10);
      const double share = least_share(a, b, zone, parked, d);
      if (holds(spans, d)) {
        ++taken;
        EXPECT_LE(share, 1.1) << "case " << k << ", difference " << d;
        continue;
      }
      ++free;
      EXPECT_GT(share, 1) << "case " << k << ", difference " << d;
      const PairResult proof = check_pair({&a, 0}, {&b, d}, zones, parked);
      EXPECT_TRUE(proof.apart) << "case " << k << ", difference " << d;
    }
  }
  EXPECT_GT(free, 500);
  EXPECT_GT(taken, 500);
}

// Just beside the ends of the intervals, where it is closest.
TEST(ForbiddenBetween, AreProvedRightBesideTheirEnds) {
  geom::SplitMix64 random(5);
  int ends = 0;
  for (int k = 0; k < 200; ++k) {
    const Trajectory a = random_flight(random, 60, 10);
    const Trajectory b = random_flight(random, 60, 10);
    const std::vector<Zone> zones{cylinder(random.uniform(2, 15), random.uniform(1, 5))};
    const auto spans = forbidden_departures(a, b, zones, Parked::gone);
    for (const DepartureSpan& span : spans) {
      for (const double d : {span.low - 1e-6, span.high + 1e-6}) {
        if (holds(spans, d)) continue;
        ++ends;
        EXPECT_TRUE(check_pair({&a, 0}, {&b, d}, zones, Parked::gone).apart)
            << "case " << k << ", difference " << d;
      }
    }
  }
  EXPECT_GT(ends, 100);
}

}  // namespace
}  // namespace traj
