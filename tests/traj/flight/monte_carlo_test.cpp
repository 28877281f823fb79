#include "traj/flight/monte_carlo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "traj/flight/simulate.h"
#include "traj/flights.h"

namespace traj {
namespace {

TEST(MonteCarlo, DrawsWithinWhatIsAsked) {
  FlightOptions base = testing::example_flight();
  base.wind.mean = {3, 4, 0.5};
  std::set<double> masses;
  for (std::size_t i = 0; i < 500; ++i) {
    const FlightOptions o = drawn(base, {500, 0.1}, i);
    EXPECT_LE(o.wind.mean.norm(), base.wind.mean.norm() + 1e-12);
    EXPECT_LE(std::abs(o.mass_error), 0.1);
    masses.insert(o.mass_error);
  }
  EXPECT_EQ(masses.size(), 500u);
}

TEST(MonteCarlo, IsTheSameForAnyThreads) {
  FlightOptions base = testing::example_flight();
  base.wind = {Vec3(3, 0, 0), 3};
  const ReferenceTrack track(testing::line({5, 0, 0}, 4));
  const TrackingTube one = tube_of(fly_runs(track, base, {20, 0.1}, {1, {}}));
  const TrackingTube seven = tube_of(fly_runs(track, base, {20, 0.1}, {7, {}}));
  EXPECT_EQ(one.radius, seven.radius);
  ASSERT_EQ(one.radius.size(), 40u);
  EXPECT_EQ(one.saturated, seven.saturated);
  // With 20 runs the 99.9th percentile is the largest.
  double largest = 0;
  for (const Tracking& t : one.tracking) largest = std::max(largest, t.largest);
  EXPECT_EQ(*std::max_element(one.radius.begin(), one.radius.end()), largest);
}

TEST(TubePeriods, CoverTheDuration) {
  EXPECT_EQ(tube_periods(0.05), 1u);
  EXPECT_EQ(tube_periods(1), 10u);
  EXPECT_EQ(tube_periods(1.01), 11u);
}

TEST(TrackingTube, SaysTheShareThatItsRunsCanShow) {
  EXPECT_DOUBLE_EQ(tube_share(12), 12.0 / 13);
  EXPECT_DOUBLE_EQ(tube_share(1), 0.5);
  EXPECT_DOUBLE_EQ(tube_share(999), 0.999);
  EXPECT_LE(tube_share(1000), 0.999);
  EXPECT_DOUBLE_EQ(tube_share(1'000'000), 0.999 * 1e6 / (1e6 + 1));
}

TEST(TrackingTube, HoldsTheHoverAtTheEnd) {
  FlightOptions base = testing::example_flight();
  base.wind = {Vec3(6, 0, 0), 6};
  const ReferenceTrack track(testing::line({5, 0, 0}, 4));
  const auto runs = fly_runs(track, base, {5, 0.1}, {});
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Flight flight = simulate(track, drawn(base, {5, 0.1}, i), {});
    double hover = 0;
    for (std::size_t k = 390; k < flight.error.size(); ++k) {
      hover = std::max(hover, flight.error[k]);
    }
    EXPECT_EQ(runs[i].largest.back(), hover) << i;
  }
}

TEST(TrackingTube, IsTheLargestErrorButForOneInAThousand) {
  std::vector<RunOutcome> outcomes(2000);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const double error = static_cast<double>((i * 7) % 2000);  // each of 0 to 1999 once
    outcomes[i].largest = {error, 2 * error};
    outcomes[i].saturated = i % 2 ? 1 : 0;
  }
  const TrackingTube tube = tube_of(outcomes);
  EXPECT_EQ(tube.lost, 0u);
  EXPECT_EQ(tube.radius, (std::vector<double>{1997, 2 * 1997}));
  EXPECT_NEAR(tube.saturated, 0.5, 1e-9);
  EXPECT_EQ(tube.tracking.size(), 2000u);
  outcomes.resize(999);
  EXPECT_EQ(tube_of(outcomes).radius[0], 1999) << "i = 857: of fewer, the largest";
}

TEST(TrackingTube, IsNoneWhereAFlightWasLost) {
  std::vector<RunOutcome> outcomes(3);
  for (RunOutcome& o : outcomes) o.largest = {1};
  outcomes[1].lost = true;
  const TrackingTube tube = tube_of(outcomes);
  EXPECT_EQ(tube.lost, 1u);
  EXPECT_TRUE(tube.radius.empty());
  EXPECT_TRUE(tube.tracking.empty());
}

}  // namespace
}  // namespace traj
