#include "traj/together/check_together.h"

#include <gtest/gtest.h>

#include <deque>

#include "support/pair_case.h"

namespace traj {
namespace {

struct Sky {
  std::deque<Trajectory> trajectories;
  std::vector<TimedFlight> flights;
};

Sky random_sky(std::uint64_t seed, int count) {
  support::Random random(seed);
  Sky sky;
  for (int i = 0; i < count; ++i) {
    sky.trajectories.push_back({{support::random_segment(random, random.uniform(1, 20))}});
    sky.flights.push_back({&sky.trajectories.back(), random.uniform(0, 20), {6, 6, 3}});
  }
  return sky;
}

TEST(CheckTogether, RefusesThePairsThatAreRefusedByThemselves) {
  const Sky sky = random_sky(1, 80);
  for (const Spacing& spacing :
       {Spacing{}, Spacing{cylinder(15, 8), {}}, Spacing{{}, cylinder(5, 30)}}) {
    const TogetherResult result = check_together(sky.flights, {spacing, Parked::gone});
    std::vector<FlightPair> expected;
    for (std::uint32_t i = 0; i < sky.flights.size(); ++i) {
      for (std::uint32_t k = i + 1; k < sky.flights.size(); ++k) {
        const auto zones = zones_between(spacing, sky.flights[i].room, sky.flights[k].room);
        if (!check_pair(sky.flights[i], sky.flights[k], zones, Parked::gone).apart) {
          expected.push_back({i, k});
        }
      }
    }
    std::vector<FlightPair> found;
    for (const RefusedPair& pair : result.refused) found.push_back(pair.flights);
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(result.pairs, 80u * 79 / 2);
    EXPECT_GE(result.near, expected.size());
  }
}

TEST(CheckTogether, IsTheSameForAnyThreads) {
  const Sky sky = random_sky(2, 300);
  const Spacing spacing{cylinder(5, 3), {}};
  const auto one = check_together(sky.flights, {spacing, Parked::pad});
  for (const unsigned threads : {2u, 7u}) {
    const auto many = check_together(sky.flights, {spacing, Parked::pad}, {threads, {}});
    ASSERT_EQ(many.refused.size(), one.refused.size());
    EXPECT_EQ(many.near, one.near);
    EXPECT_EQ(many.pieces, one.pieces);
    for (std::size_t i = 0; i < one.refused.size(); ++i) {
      EXPECT_EQ(many.refused[i].flights, one.refused[i].flights);
      EXPECT_EQ(many.refused[i].result.share, one.refused[i].result.share);
    }
  }
}

TEST(CheckTogether, ProvesEachNearPairThatItAccepts) {
  const Sky sky = random_sky(4, 60);
  const auto result = check_together(sky.flights, {{cylinder(5, 3), {}}, Parked::gone, true});
  EXPECT_EQ(result.proved.size() + result.refused.size(), result.near);
  EXPECT_FALSE(result.proved.empty());
  for (const ProvedPair& pair : result.proved) EXPECT_TRUE(pair.proof.apart);
}

TEST(CheckTogether, IsFineOfOneFlightAndOfNone) {
  const Sky sky = random_sky(3, 1);
  EXPECT_TRUE(check_together(sky.flights, {}).ok());
  EXPECT_TRUE(check_together({}, {}).ok());
}

}  // namespace
}  // namespace traj
