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
  EXPECT_LT(one.cost, before.rms);
  base.gains = one.gains;
  EXPECT_EQ(tracking(simulate(tracks[0], base, {}), 3).rms, one.cost);
}

}  // namespace
}  // namespace traj
