#include "traj/flight/tune.h"

#include <gtest/gtest.h>

#include "traj/flight/simulate.h"
#include "traj/flights.h"

namespace traj {
namespace {

TEST(Tune, FindsBetterGainsAndTheSameForAnyThreads) {
  FlightOptions base = testing::example_flight();
  base.hover = 0.1;
  base.settle = 0.1;
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({4, 2, 1}, 3))};
  const Tracking before = tracking(simulate(tracks[0], base, {}), 3);
  const TuneResult one = tune(tracks, base, {}, {1, {}});
  const TuneResult two = tune(tracks, base, {}, {2, {}});
  EXPECT_EQ(one.gains.velocity.p, two.gains.velocity.p);
  EXPECT_EQ(one.gains.position.p, two.gains.position.p);
  EXPECT_EQ(one.flights, two.flights);
  EXPECT_TRUE(one.improved);
  EXPECT_EQ(one.before, before.rms);
  EXPECT_LT(one.cost, before.rms);
  base.gains = one.gains;
  EXPECT_EQ(tracking(simulate(tracks[0], base, {}), 3).rms, one.cost);
}

// Gains that were found without noise leave nothing to find with much of it: what the velocity loop
// then likes best makes the trajectory worse.
TEST(Tune, NeverHandsOutWorse) {
  FlightOptions base = testing::example_flight();
  base.hover = 0.1;
  base.settle = 0.1;
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({4, 2, 1}, 3))};
  base.gains = tune(tracks, base, {}, {}).gains;
  base.sensors.position = 0.02;
  base.sensors.velocity = 0.1;
  for (base.seed = 0; base.seed < 3; ++base.seed) {
    const TuneResult found = tune(tracks, base, {}, {});
    const double before = tracking(simulate(tracks[0], base, {}), 3).rms;
    FlightOptions after = base;
    after.gains = found.gains;
    EXPECT_EQ(found.before, before);
    EXPECT_EQ(found.cost, tracking(simulate(tracks[0], after, {}), 3).rms);
    EXPECT_LE(found.cost, before);
    EXPECT_EQ(found.improved, found.cost < before);
  }
}

TEST(Tune, KeepsTheGainsWhereAllAreAlike) {
  FlightOptions base = testing::example_flight();
  base.hover = 0.1;
  base.settle = 0.1;
  base.gains.velocity.p = {1.25, 1.5, 2};  // x and y apart, as no search leaves them
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({4, 2, 1}, 3))};
  FlightCost nothing;
  nothing.rms = 0;
  const TuneResult found = tune(tracks, base, nothing, {});
  EXPECT_FALSE(found.improved);
  EXPECT_EQ(found.gains.velocity.p, base.gains.velocity.p);
  EXPECT_EQ(found.gains.position.p, base.gains.position.p);
}

TEST(Tune, SaysThatFlightsWereLost) {
  FlightOptions base = testing::example_flight();
  base.mass_error = 9;  // too heavy to fly with any gains
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({4, 2, 1}, 3))};
  const TuneResult found = tune(tracks, base, {}, {});
  EXPECT_FALSE(found.before);
  EXPECT_FALSE(found.cost);
  EXPECT_FALSE(found.improved);
}

}  // namespace
}  // namespace traj
