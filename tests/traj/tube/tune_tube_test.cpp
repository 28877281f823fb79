#include "traj/tube/tune_tube.h"

#include <gtest/gtest.h>

#include "step_case.h"

namespace traj {
namespace {

FlightOptions flight_of(std::string_view vehicle) {
  FlightOptions options = testing::flight_of(vehicle);
  options.hover = 0.05;
  options.settle = 0.05;
  return options;
}

TEST(TuneTube, FindsALesserTubeAndTheSameForAnyThreads) {
  const FlightOptions base = flight_of("quad2kg");
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({0.2, 0.1, 0}, 1))};
  const Disturbances gusts{.wind = {1, 0, 0}, .gust_most = 0.3};
  const TuneResult one = tune_tube(tracks, base, gusts, {1, {}}, 2);
  const TuneResult two = tune_tube(tracks, base, gusts, {2, {}}, 2);
  EXPECT_EQ(one.cost, two.cost);
  EXPECT_EQ(one.gains.geometric.velocity, two.gains.geometric.velocity);
  EXPECT_EQ(one.flights, two.flights);
  ASSERT_TRUE(one.improved && one.before && one.cost);
  EXPECT_LT(*one.cost, *one.before);
  // The cost is that of its own gains.
  EXPECT_EQ(*one.before, prove_tube(tracks[0], base, gusts, {}).largest);
  FlightOptions after = base;
  after.gains = one.gains;
  EXPECT_EQ(*one.cost, prove_tube(tracks[0], after, gusts, {}).largest);
}

// Nothing is claimed of gains that have no proof.
TEST(TuneTube, SaysWhereThereIsNoProof) {
  const FlightOptions base = flight_of("quad2kg");
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(testing::line({0.2, 0, 0}, 0.5))};
  const TuneResult found = tune_tube(tracks, base, {.gust_most = 40}, {}, 1);
  EXPECT_FALSE(found.before);
  EXPECT_FALSE(found.cost);
}

}  // namespace
}  // namespace traj
