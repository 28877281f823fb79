#include "traj/flight/simulate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "traj/curve/to_enu.h"
#include "traj/curve/yaw.h"
#include "traj/flight/tracking.h"
#include "traj/flights.h"
#include "traj/scenes.h"

namespace traj {
namespace {

TEST(Simulate, HoversExactlyWithoutWind) {
  FlightOptions options = testing::example_flight();
  State there;
  there.position = {1, 2, 3};
  const ReferenceTrack track({{hermite(there, there, 5)}});
  for (const ControlLaw law : {ControlLaw::cascade, ControlLaw::geometric}) {
    options.law = law;
    const Flight flight = simulate(track, options, {10, true});
    EXPECT_LT(*std::max_element(flight.error.begin(), flight.error.end()), 1e-9);
    EXPECT_NEAR(flight.hover_seconds, 8, 0.02);
    EXPECT_EQ(flight.error.size(), 801u);
    EXPECT_EQ(flight.samples.size(), 801u);
    EXPECT_EQ(flight.path.size(), 8001u);
    EXPECT_EQ(flight.samples.back().time, 8);
  }
}

TEST(Simulate, FollowsALineAndStaysAtItsEnd) {
  FlightOptions options = testing::example_flight();
  const ReferenceTrack track(testing::line({10, 5, 3}, 6));
  for (const ControlLaw law : {ControlLaw::cascade, ControlLaw::geometric}) {
    options.law = law;
    const Flight flight = simulate(track, options, {});
    const Tracking t = tracking(flight, 6);
    EXPECT_FALSE(flight.lost);
    EXPECT_LT(t.largest, 0.25);
    EXPECT_LT(t.final_distance, 0.05);
    EXPECT_TRUE(t.settling);
    EXPECT_LE(t.mean, t.rms);
    EXPECT_LE(t.rms, t.largest);
  }
}

TEST(Simulate, LooksWhereTheTrajectorySays) {
  Trajectory trajectory = testing::line({20, 20, 0}, 12);
  add_yaw({YawOptions::Kind::fixed, 2.0}, trajectory);
  const Flight flight =
      simulate(ReferenceTrack(trajectory), testing::example_flight(), {10, false});
  const Vec3 ahead = flight.samples.back().attitude * Vec3::UnitX();
  EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), 2.0, 1e-3);
  EXPECT_NEAR(flight.samples[100].setpoint_yaw, 2.0, 1e-12);
}

// A mission over a map of either axes is one flight.
TEST(Simulate, IsTheSameFromEitherAxes) {
  Trajectory enu = testing::random_trajectory(3);
  Trajectory neu = enu;
  for (Segment& s : neu.segments) {
    for (Vec3& p : s.point) p = geom::to_enu(geom::Axes::neu, p);
  }
  const auto log = [](geom::Axes axes, const Trajectory& t) {
    return simulate(ReferenceTrack(to_enu(axes, t)), testing::example_flight(), {10, false})
        .samples;
  };
  const auto a = log(geom::Axes::enu, enu);
  const auto b = log(geom::Axes::neu, neu);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].position, b[i].position) << i;
    ASSERT_EQ(a[i].attitude.coeffs(), b[i].attitude.coeffs()) << i;
  }
}

TEST(Simulate, RepeatsItselfAndListensToTheSeed) {
  FlightOptions options = testing::example_flight();
  options.wind = {Vec3(3, 1, 0), 3};
  options.sensors = {0.02, 0.05, 0.01, 0.02, 0.02};
  const ReferenceTrack track(testing::line({10, 5, 3}, 6));
  const Flight once = simulate(track, options, {});
  EXPECT_EQ(once.error, simulate(track, options, {}).error);
  options.seed = 1;
  EXPECT_NE(once.error, simulate(track, options, {}).error);
}

TEST(Simulate, HeavierThanBelievedItSagsAndRecovers) {
  FlightOptions options = testing::example_flight();
  options.mass_error = 0.3;
  options.hover = 0;
  State there;
  const ReferenceTrack track({{hermite(there, there, 20)}});
  const Flight flight = simulate(track, options, {});
  EXPECT_GT(*std::max_element(flight.error.begin(), flight.error.end()), 0.05);
  EXPECT_LT(flight.error.back(), 0.01);  // the velocity loop's integral carries the weight
}

// What bounds the way between steps is the true mass: lighter vehicles accelerate harder.
TEST(Simulate, KnowsTheTrueVehicle) {
  FlightOptions options = testing::example_flight();
  options.mass_error = -0.5;
  EXPECT_EQ(true_vehicle(options).mass, 0.5);
  EXPECT_EQ(true_vehicle(options).motor_most, options.quadrotor.motor_most);
  const ReferenceTrack track(testing::line({10, 0, 0}, 3));
  const Flight flight = simulate(track, options, {0, true});
  const double most = acceleration_bound(true_vehicle(options), flight.fastest_air + 1);
  for (std::size_t i = 1; i + 1 < flight.path.size(); ++i) {
    const Vec3 bend = flight.path[i - 1] - 2 * flight.path[i] + flight.path[i + 1];
    ASSERT_LE(bend.norm(), most * 1e-6 + 1e-12) << i;
  }
}

TEST(Simulate, SaysWhenItIsLost) {
  FlightOptions options = testing::example_flight();
  options.gains.attitude *= -1;
  options.wind.mean = {2, 0, 0};
  const Flight flight =
      simulate(ReferenceTrack(testing::line({10, 0, 0}, 60)), options, {10, true});
  ASSERT_TRUE(flight.lost);
  EXPECT_LT(flight.samples.size(), 6000u);
  for (const FlightSample& s : flight.samples) EXPECT_TRUE(s.position.allFinite());
  for (const Vec3& p : flight.path) EXPECT_TRUE(p.allFinite());
  EXPECT_EQ(flight.path.size(), (flight.error.size() - 1) * 10 + 1);
}

}  // namespace
}  // namespace traj
