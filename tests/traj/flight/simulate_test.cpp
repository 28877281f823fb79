#include "traj/flight/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "traj/scenes.h"
#include "traj/curve/to_enu.h"
#include "traj/curve/yaw.h"
#include "traj/flight/flown_path.h"
#include "traj/flight/monte_carlo.h"
#include "traj/flight/tune.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

FlightOptions example() {
  FlightOptions o;
  Quadrotor& q = o.quadrotor;
  q.mass = 1;
  q.inertia = {0.01, 0.01, 0.02};
  q.arm = {0.15, 0.15};
  q.motor_time_constant = 0.02;
  q.motor_most = 6;
  q.drag = Vec3::Constant(0.1);
  o.gains = nominal_gains(q, 0.6);
  return o;
}

Trajectory line(const Vec3& to, double seconds) {
  State end;
  end.position = to;
  return {{hermite({}, end, seconds)}};
}

TEST(Simulate, HoversExactlyWithoutWind) {
  FlightOptions options = example();
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
  FlightOptions options = example();
  const ReferenceTrack track(line({10, 5, 3}, 6));
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
  Trajectory trajectory = line({20, 20, 0}, 12);
  add_yaw({YawOptions::Kind::fixed, 2.0}, trajectory);
  const Flight flight = simulate(ReferenceTrack(trajectory), example(), {10, false});
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
    return simulate(ReferenceTrack(to_enu(axes, t)), example(), {10, false}).samples;
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
  FlightOptions options = example();
  options.wind = {Vec3(3, 1, 0), 3};
  options.sensors = {0.02, 0.05, 0.01, 0.02, 0.02};
  const ReferenceTrack track(line({10, 5, 3}, 6));
  const Flight once = simulate(track, options, {});
  EXPECT_EQ(once.error, simulate(track, options, {}).error);
  options.seed = 1;
  EXPECT_NE(once.error, simulate(track, options, {}).error);
}

TEST(Simulate, HeavierThanBelievedItSagsAndRecovers) {
  FlightOptions options = example();
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
  FlightOptions options = example();
  options.mass_error = -0.5;
  EXPECT_EQ(true_vehicle(options).mass, 0.5);
  EXPECT_EQ(true_vehicle(options).motor_most, options.quadrotor.motor_most);
  const ReferenceTrack track(line({10, 0, 0}, 3));
  const Flight flight = simulate(track, options, {0, true});
  const double most = acceleration_bound(true_vehicle(options), flight.fastest_air + 1);
  for (std::size_t i = 1; i + 1 < flight.path.size(); ++i) {
    const Vec3 bend = flight.path[i - 1] - 2 * flight.path[i] + flight.path[i + 1];
    ASSERT_LE(bend.norm(), most * 1e-6 + 1e-12) << i;
  }
}

TEST(Simulate, SaysWhenItIsLost) {
  FlightOptions options = example();
  options.gains.attitude *= -1;
  options.wind.mean = {2, 0, 0};
  const Flight flight = simulate(ReferenceTrack(line({10, 0, 0}, 60)), options, {10, true});
  ASSERT_TRUE(flight.lost);
  EXPECT_LT(flight.samples.size(), 6000u);
  for (const FlightSample& s : flight.samples) EXPECT_TRUE(s.position.allFinite());
  for (const Vec3& p : flight.path) EXPECT_TRUE(p.allFinite());
  EXPECT_EQ(flight.path.size(), (flight.error.size() - 1) * 10 + 1);
}

TEST(ReferenceTrack, IsTheTrajectory) {
  Trajectory trajectory = testing::random_trajectory(11);
  add_yaw({}, trajectory);
  const ReferenceTrack track(trajectory);
  std::size_t cursor = 0;
  for (double t = 0; t < duration(trajectory); t += 0.037) {
    const State exact = evaluate(trajectory, t);
    const Reference s = track.at(t, cursor);
    EXPECT_LT((s.position - exact.position).norm(), 1e-12);
    EXPECT_LT((s.velocity - exact.velocity).norm(), 1e-11);
    EXPECT_LT((s.acceleration - exact.acceleration).norm(), 1e-10);
    EXPECT_LT((s.jerk - exact.jerk).norm(), 1e-9);
    std::size_t other = 0;
    const double h = 1e-6;
    const double turn = (track.at(t + h, other).yaw - s.yaw) / h;
    EXPECT_NEAR(s.yaw_rate, turn, 1e-3);
  }
  EXPECT_EQ(track.at(-1, cursor).velocity, Vec3::Zero());
  EXPECT_EQ(track.at(1e3, cursor).velocity, Vec3::Zero());
  EXPECT_LT((track.at(1e3, cursor).position - trajectory.segments.back().point[7]).norm(), 1e-12);
}

TEST(Percentile, IsByNearestRank) {
  std::vector<double> v = {5, 1, 4, 2, 3};
  EXPECT_EQ(percentile(v, 0.2), 1);
  EXPECT_EQ(percentile(v, 0.21), 2);
  EXPECT_EQ(percentile(v, 1), 5);
  EXPECT_EQ(percentile(v, 0.999), 5);
}

// A flight straight along x at 10 m/s, without tilt.
Flight straight(const Vec3& from) {
  Flight flight;
  for (int i = 0; i <= 1000; ++i) flight.path.push_back(from + Vec3(i * 0.01, 0, 0));
  flight.tilt.assign(101, 0);
  flight.error.assign(101, 0);
  return flight;
}

TEST(FlownPath, IsExactOnItsSteps) {
  const auto scene = testing::scene_of({{Vec3(5.004, -1, 0), Vec3(5.006, 1, 10)}});
  const FlightPathCheck hit = check_flight_path(scene, example().quadrotor, {}, straight({0, 0, 5}));
  EXPECT_FALSE(hit.clear);
  EXPECT_EQ(hit.reason, "collision");
  EXPECT_EQ(hit.time, 0.5);
  EXPECT_EQ(hit.box, 0u);
  const FlightPathCheck miss = check_flight_path(scene, example().quadrotor, {}, straight({0, 1.0001, 5}));
  EXPECT_TRUE(miss.clear);
  const double most = acceleration_bound(example().quadrotor, 1 + 0.01 * (kGravity + 24.1));
  EXPECT_NEAR(miss.between, most * 1e-6 / 8, 1e-15);
  // Nearer than what the path may stray between steps.
  const FlightPathCheck near = check_flight_path(scene, example().quadrotor, {}, straight({0, 1.000001, 5}));
  EXPECT_EQ(near.reason, "undecided");
  EXPECT_EQ(check_flight_path(scene, example().quadrotor, {}, straight({295.005, 0, 5})).reason,
            "bounds");
}

TEST(FlownPath, IsWiderWhereItTiltsTooMuch) {
  const auto scene = testing::scene_of({{Vec3(5, -1, 0), Vec3(6, 1, 10)}});
  Flight flight = straight({0, 1.2, 5});
  const TiltedVehicle vehicle{0.5, [](double tilt) { return Vec3::Constant(tilt); }};
  EXPECT_TRUE(check_flight_path(scene, example().quadrotor, vehicle, flight).clear);
  flight.tilt[55] = 0.6;
  EXPECT_EQ(check_flight_path(scene, example().quadrotor, vehicle, flight).reason, "collision");
  flight.tilt[55] = 0;
  flight.tilt[80] = 0.6;  // past the box
  EXPECT_TRUE(check_flight_path(scene, example().quadrotor, vehicle, flight).clear);
}

TEST(Tube, IsClearExactlyWhileItIsThinnerThanTheWay) {
  const auto scene = testing::scene_of({{Vec3(4, 1, 0), Vec3(6, 2, 10)}});
  Trajectory t = line({10, 0, 0}, 10);
  for (Vec3& p : t.segments[0].point) p.z() += 5;
  std::vector<double> radius(100, 0.99);
  EXPECT_TRUE(check_tube(scene, t, radius, 0.1).clear);
  radius.assign(100, 1.01);
  EXPECT_EQ(check_tube(scene, t, radius, 0.1).reason, "collision");
  radius.assign(100, 0.5);
  radius[50] = 1.01;  // where it passes the box
  EXPECT_FALSE(check_tube(scene, t, radius, 0.1).clear);
  radius[50] = 0.5;
  radius[5] = 1.01;  // long before
  EXPECT_TRUE(check_tube(scene, t, radius, 0.1).clear);
}

TEST(MonteCarlo, DrawsWithinWhatIsAsked) {
  FlightOptions base = example();
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
  FlightOptions base = example();
  base.wind = {Vec3(3, 0, 0), 3};
  const ReferenceTrack track(line({5, 0, 0}, 4));
  const TrackingTube one = tube_of(fly_runs(track, base, {20, 0.1}, {}, {1, {}}));
  const TrackingTube seven = tube_of(fly_runs(track, base, {20, 0.1}, {}, {7, {}}));
  EXPECT_EQ(one.radius, seven.radius);
  ASSERT_EQ(one.radius.size(), 40u);
  EXPECT_EQ(one.saturated, seven.saturated);
  // With 20 runs the 99.9th percentile is the largest.
  double largest = 0;
  for (const Tracking& t : one.tracking) largest = std::max(largest, t.largest);
  EXPECT_EQ(*std::max_element(one.radius.begin(), one.radius.end()), largest);
}

TEST(Tune, FindsBetterGainsAndTheSameForAnyThreads) {
  FlightOptions base = example();
  base.hover = 0.1;
  base.settle = 0.1;
  const std::vector<ReferenceTrack> tracks = {ReferenceTrack(line({4, 2, 1}, 3))};
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
