#include "traj/fleet/fleet_conflicts.h"

#include <gtest/gtest.h>

#include "traj/fleet/random_flights.h"

namespace traj {
namespace {

using testing::random_flight;

struct Drawn {
  std::vector<Trajectory> ways;
  std::vector<FleetFlight> flights;
};

Drawn drawn(std::uint64_t seed, std::size_t count, double across) {
  geom::SplitMix64 random(seed);
  Drawn out;
  for (std::size_t i = 0; i < count; ++i) out.ways.push_back(random_flight(random, across, 30));
  for (std::size_t i = 0; i < count; ++i) {
    const double earliest = random.uniform(0, 200);
    out.flights.push_back({&out.ways[i], Vec3::Constant(0.5), earliest,
                           earliest + random.uniform(0, 60), 0, static_cast<std::uint32_t>(i)});
  }
  return out;
}

const Spacing kSpacing{cylinder(8, 3), std::nullopt};

bool same(const FleetConflicts& a, const FleetConflicts& b) {
  return a.looked_at == b.looked_at && a.pairs == b.pairs && a.ends == b.ends &&
         a.forbidden == b.forbidden;
}

TEST(FleetConflicts, AreThoseOfEachPair) {
  for (const Parked parked : {Parked::gone, Parked::pad}) {
    const Drawn fleet = drawn(6, 40, 300);
    const auto& f = fleet.flights;
    const FleetConflicts found = fleet_conflicts(f, kSpacing, parked);
    EXPECT_LT(found.looked_at, 40u * 39 / 2);
    std::size_t next = 0;
    for (std::uint32_t a = 0; a < f.size(); ++a) {
      for (std::uint32_t b = a + 1; b < f.size(); ++b) {
        const DepartureSpan window{f[b].earliest - f[a].latest, f[b].latest - f[a].earliest};
        const auto expected = testing::forbidden_departures(
            *f[a].trajectory, *f[b].trajectory, zones_between(kSpacing, f[a].room, f[b].room),
            parked, window);
        if (expected.empty()) continue;
        ASSERT_LT(next, found.pairs.size());
        ASSERT_EQ(found.pairs[next], (FlightPair{a, b}));
        const auto spans = found.of(next++);
        ASSERT_EQ(spans.size(), expected.size());
        for (std::size_t i = 0; i < spans.size(); ++i) {
          EXPECT_NEAR(spans[i].low, expected[i].low, 1e-9);
          EXPECT_NEAR(spans[i].high, expected[i].high, 1e-9);
        }
      }
    }
    EXPECT_EQ(next, found.pairs.size());
    EXPECT_GT(next, 5u);
  }
}

TEST(FleetConflicts, AreTheSameForAnyNumberOfThreads) {
  const Drawn fleet = drawn(7, 120, 400);
  const FleetConflicts one = fleet_conflicts(fleet.flights, kSpacing, Parked::gone);
  EXPECT_TRUE(same(one, fleet_conflicts(fleet.flights, kSpacing, Parked::gone, {7, {}})));
}

TEST(FleetConflicts, WaysOfOneFlightAreNoPair) {
  Drawn fleet = drawn(8, 2, 50);
  fleet.ways[1] = fleet.ways[0];
  fleet.flights[1].earliest = fleet.flights[0].earliest;
  fleet.flights[1].latest = fleet.flights[0].latest;
  EXPECT_EQ(fleet_conflicts(fleet.flights, kSpacing, Parked::gone).pairs.size(), 1u);
  fleet.flights[1].number = 0;
  EXPECT_TRUE(fleet_conflicts(fleet.flights, kSpacing, Parked::gone).pairs.empty());
}

TEST(FleetConflicts, TwoThatAreSettledAreNoPair) {
  Drawn fleet = drawn(8, 2, 50);
  fleet.ways[1] = fleet.ways[0];
  for (FleetFlight& flight : fleet.flights) flight.earliest = flight.latest = 5;
  fleet.flights[0].settled = true;
  EXPECT_EQ(fleet_conflicts(fleet.flights, kSpacing, Parked::gone).pairs.size(), 1u);
  fleet.flights[1].settled = true;
  const FleetConflicts none = fleet_conflicts(fleet.flights, kSpacing, Parked::gone);
  EXPECT_TRUE(none.pairs.empty());
  EXPECT_EQ(none.looked_at, 0u);
}

TEST(FleetConflicts, NoFlightsHaveNone) {
  EXPECT_TRUE(fleet_conflicts({}, kSpacing, Parked::pad).pairs.empty());
}

}  // namespace
}  // namespace traj
