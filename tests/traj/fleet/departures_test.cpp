#include "traj/fleet/departures.h"

#include <gtest/gtest.h>

#include <array>

#include "traj/fleet/random_flights.h"
#include "traj/together/check_together.h"

namespace traj {
namespace {

using testing::random_flight;

// Flights without ways: what is forbidden is given.
std::vector<FleetFlight> flights(std::size_t count, double wait = 100) {
  std::vector<FleetFlight> out(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    out[i].latest = wait;
    out[i].number = i;
  }
  return out;
}

FleetConflicts conflicts(const std::vector<std::pair<FlightPair, DepartureSpan>>& list) {
  FleetConflicts out;
  for (const auto& [pair, span] : list) {
    out.pairs.push_back(pair);
    out.forbidden.push_back(span);
    out.ends.push_back(out.forbidden.size());
  }
  return out;
}

TEST(ChooseDepartures, FirstComeFirstServed) {
  const auto c = conflicts({{{0, 1}, {-5, 5}}, {{0, 2}, {-7.0001, 7.0001}}, {{1, 2}, {-1, 1}}});
  const Departures chosen = choose_departures(flights(3), c);
  EXPECT_EQ(chosen.of[0].start, 0);
  EXPECT_EQ(chosen.of[1].start, 5.001) << "the first whole millisecond after";
  EXPECT_EQ(chosen.of[2].start, 7.001);
  EXPECT_NEAR(chosen.before, 12.002, 1e-9);
}

TEST(ChooseDepartures, TakesAGapThatIsThere) {
  auto c = conflicts({{{0, 1}, {-5, 1}}});
  c.forbidden.push_back({3, 9});
  c.ends.back() = 2;
  EXPECT_EQ(choose_departures(flights(2), c).of[1].start, 1.001);
}

TEST(ChooseDepartures, HigherPriorityGoesFirst) {
  auto f = flights(2);
  f[1].priority = 1;
  const Departures chosen = choose_departures(f, conflicts({{{0, 1}, {-5, 3}}}));
  EXPECT_EQ(chosen.of[1].start, 0);
  EXPECT_EQ(chosen.of[0].start, 5.001) << "the first after the second: differences the other way";
}

TEST(ChooseDepartures, RefusesWithThoseInTheWay) {
  const auto f = flights(3, 4);
  const Departures chosen =
      choose_departures(f, conflicts({{{0, 2}, {-5, 5}}, {{1, 2}, {20, 30}}}));
  EXPECT_FALSE(chosen.of[2].start);
  EXPECT_EQ(chosen.of[2].blocked, (std::vector<std::uint32_t>{0}));
}

TEST(ChooseDepartures, TakesTheLatestAndNoLater) {
  const auto c = conflicts({{{0, 1}, {-5, 3.9995}}});
  EXPECT_EQ(choose_departures(flights(2, 4), c).of[1].start, 4);
  EXPECT_FALSE(choose_departures(flights(2, 3.9999), c).of[1].start);
}

TEST(ChooseDepartures, GoesAnotherWayOnlyWhereItWouldBeRefused) {
  auto f = flights(3, 4);
  f[2].number = 1;
  const Departures other = choose_departures(f, conflicts({{{0, 1}, {-5, 5}}}));
  ASSERT_EQ(other.of.size(), 2u);
  EXPECT_EQ(other.of[1].flight, 2u);
  EXPECT_EQ(other.of[1].start, 0);
  const Departures waits = choose_departures(f, conflicts({{{0, 1}, {-3, 3}}}));
  EXPECT_EQ(waits.of[1].flight, 1u);
  EXPECT_EQ(waits.of[1].start, 3.001);
}

TEST(ChooseDepartures, ImprovesByLettingOneGoFirst) {
  // The first makes two others wait; behind them it waits itself, and less.
  const auto c = conflicts({{{0, 1}, {-1, 50}}, {{0, 2}, {-1, 50}}});
  const Departures before = choose_departures(flights(3), c);
  EXPECT_NEAR(before.before, 100.002, 1e-9);
  const Departures after = choose_departures(flights(3), c, {5, 1});
  EXPECT_EQ(after.of[1].start, 0);
  EXPECT_EQ(after.of[2].start, 0);
  EXPECT_EQ(after.of[0].start, 1.001);
  EXPECT_GT(after.moved, 0u);
}

// The second may not wait, the first may.
TEST(ChooseDepartures, RescuesWhoWouldBeRefused) {
  auto f = flights(2);
  f[1].latest = 0;
  const auto c = conflicts({{{0, 1}, {-5, 5}}});
  EXPECT_FALSE(choose_departures(f, c).of[1].start);
  const Departures chosen = choose_departures(f, c, {.rescue = 1});
  EXPECT_EQ(chosen.of[1].start, 0);
  EXPECT_EQ(chosen.of[0].start, 5.001);
  EXPECT_EQ(chosen.rescued, 1u);
}

// Where none is refused, and where nothing may be moved, rescue changes nothing.
TEST(ChooseDepartures, RescuesNobodyWhereNobodyNeedsItOrItCannotHelp) {
  const auto c = conflicts({{{0, 1}, {-1, 50}}, {{0, 2}, {-1, 50}}});
  const Departures plain = choose_departures(flights(3), c);
  const Departures same = choose_departures(flights(3), c, {.rescue = 20});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(same.of[i].start, plain.of[i].start);
  EXPECT_EQ(same.moved, 0u);
  auto f = flights(2, 4);
  f[0].settled = true;
  std::size_t rounds = 0;
  const auto count = [&](std::size_t, std::size_t) { ++rounds; };
  const auto none =
      choose_departures(f, conflicts({{{0, 1}, {-50, 50}}}), {.rescue = 20}, {1, count});
  EXPECT_FALSE(none.of[1].start);
  EXPECT_EQ(none.rescued, 0u);
  EXPECT_LE(rounds, 1u) << "no round is made for it";
}

TEST(ChooseDepartures, NoRoundMovesHigherPriorityBack) {
  auto f = flights(3);
  f[0].priority = 2;
  const auto c = conflicts({{{0, 1}, {-1, 50}}, {{0, 2}, {-1, 50}}});
  EXPECT_EQ(choose_departures(f, c, {5, 1}).of[0].start, 0);
}

TEST(ChooseDepartures, NoRoundRefusesOneForAnother) {
  // Only one can depart: the first, although it has to wait and the second would not.
  auto f = flights(2);
  f[0].forbidden = {{-1, 3}};
  const auto c = conflicts({{{0, 1}, {-1000, 1000}}});
  const Departures chosen = choose_departures(f, c, {5, 1});
  EXPECT_EQ(chosen.of[0].start, 3.001);
  EXPECT_FALSE(chosen.of[1].start);
  EXPECT_EQ(chosen.moved, 0u);
}

TEST(ChooseDepartures, WhatIsSettledGoesFirstAndStays) {
  auto f = flights(3);
  f[0].priority = 9;
  f[2].settled = true;
  f[2].earliest = f[2].latest = 4;
  const auto c = conflicts({{{0, 1}, {-5, 5}}, {{0, 2}, {-1, 20}}, {{1, 2}, {-1, 1}}});
  for (const int improve : {0, 20}) {
    const Departures chosen = choose_departures(f, c, {improve, 1});
    EXPECT_EQ(chosen.of[2].start, 4);
    EXPECT_EQ(chosen.of[0].start, 5.001) << "the settled one departs 1 s sooner, or 20 s later";
    EXPECT_EQ(chosen.of[1].start, 0);
  }
}

TEST(ChooseDepartures, NamesWhatIsSettledAmongThoseInTheWay) {
  auto f = flights(2, 4);
  f[1].settled = true;
  f[1].latest = 0;
  const Departures refused = choose_departures(f, conflicts({{{0, 1}, {-50, 50}}}), {5, 1});
  EXPECT_FALSE(refused.of[0].start);
  EXPECT_EQ(refused.of[0].blocked, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(refused.of[1].start, 0);
}

TEST(ChooseDepartures, TwoThatAreSettledDepartAlthoughTheyMeet) {
  auto f = flights(2);
  for (FleetFlight& flight : f) {
    flight.settled = true;
    flight.earliest = flight.latest = 7;
  }
  const Departures chosen = choose_departures(f, conflicts({{{0, 1}, {-50, 50}}}), {5, 1});
  EXPECT_EQ(chosen.of[0].start, 7);
  EXPECT_EQ(chosen.of[1].start, 7);
}

TEST(ConflictsAsAsked, CountsPairsOnce) {
  auto f = flights(3);
  f[1].earliest = 5;
  const auto c = conflicts({{{0, 1}, {-5, 5}}, {{0, 2}, {1, 2}}, {{1, 2}, {-6, -5}}});
  EXPECT_EQ(conflicts_as_asked(f, c), 2u);
}

// Flights among others that are settled: whatever departs is proved apart from all of them, and no
// sampled instant says otherwise.
TEST(ChooseDepartures, AreProvedBesideWhatIsSettled) {
  const Zone zone = cylinder(8, 3);
  const Spacing spacing{zone, std::nullopt};
  std::size_t waited = 0;
  std::size_t without = 0;
  for (const std::uint64_t seed : {21, 22, 23, 24, 25, 26}) {
    geom::SplitMix64 random(seed);
    const Parked parked = seed % 2 ? Parked::gone : Parked::pad;
    std::vector<Trajectory> ways;
    for (int i = 0; i < 24; ++i) ways.push_back(random_flight(random, 60, 8));
    std::vector<FleetFlight> f;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
      const double earliest = random.uniform(0, 60);
      f.push_back({&ways[i], Vec3::Constant(0.5), earliest, earliest + 120, random.whole(0, 2), i});
      if (i % 3 != 0) continue;
      f.back().latest = earliest;
      f.back().settled = true;
    }
    const Departures chosen = choose_departures(f, fleet_conflicts(f, spacing, parked), {10, seed});
    for (std::uint32_t a = 0; a < f.size(); ++a) {
      const auto& start = chosen.of[a].start;
      if (f[a].settled) {
        ASSERT_EQ(start, f[a].earliest);
        continue;
      }
      if (!start) {
        ++without;
        continue;
      }
      waited += *start > f[a].earliest;
      for (std::uint32_t b = 0; b < f.size(); ++b) {
        if (a == b || !chosen.of[b].start) continue;
        const TimedFlight one{&ways[a], *start, f[a].room};
        const TimedFlight other{&ways[b], *chosen.of[b].start, f[b].room};
        ASSERT_TRUE(check_pair(one, other, std::array{zone}, parked).apart) << seed << a << b;
        ASSERT_GT(testing::least_share(ways[a], ways[b], zone, parked, other.start - one.start), 1);
      }
    }
  }
  EXPECT_GT(waited, 5u);
  EXPECT_GT(without, 1u);
}

// From random flights to departures that the check of pairs proves.
TEST(ChooseDepartures, AreProved) {
  const Spacing spacing{cylinder(8, 3), std::nullopt};
  for (const std::uint64_t seed : {11, 12, 13}) {
    geom::SplitMix64 random(seed);
    std::vector<Trajectory> ways;
    for (int i = 0; i < 80; ++i) ways.push_back(random_flight(random, 120, 15));
    std::vector<FleetFlight> f;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
      const double earliest = random.uniform(0, 120);
      f.push_back({&ways[i], Vec3::Constant(0.5), earliest, earliest + 300, random.whole(0, 2), i});
    }
    const FleetConflicts c = fleet_conflicts(f, spacing, Parked::gone);
    const Departures first = choose_departures(f, c);
    const Departures chosen = choose_departures(f, c, {20, seed});
    std::vector<TimedFlight> timed;
    double sum = 0;
    for (const Departure& departure : chosen.of) {
      ASSERT_TRUE(departure.start);
      const FleetFlight& flight = f[departure.flight];
      EXPECT_GE(*departure.start, flight.earliest);
      EXPECT_LE(*departure.start, flight.latest);
      sum += *departure.start - flight.earliest;
      timed.push_back({flight.trajectory, *departure.start, flight.room});
    }
    EXPECT_TRUE(check_together(timed, {spacing, Parked::gone}).ok());
    EXPECT_EQ(chosen.before, first.before);
    EXPECT_LE(sum, first.before);
    EXPECT_GT(conflicts_as_asked(f, c), 0u);
  }
}

}  // namespace
}  // namespace traj
