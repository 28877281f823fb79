#include "traj/flight/flown_path.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "traj/flight/simulate.h"
#include "traj/flights.h"
#include "traj/scenes.h"

namespace traj {
namespace {

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
  const FlightPathCheck hit =
      check_flight_path(scene, testing::example_flight().quadrotor, {}, straight({0, 0, 5}));
  EXPECT_FALSE(hit.clear);
  EXPECT_EQ(hit.reason, Reason::collision);
  EXPECT_EQ(hit.time, 0.5);
  EXPECT_EQ(hit.box, 0u);
  const FlightPathCheck miss =
      check_flight_path(scene, testing::example_flight().quadrotor, {}, straight({0, 1.0001, 5}));
  EXPECT_TRUE(miss.clear);
  const double most =
      acceleration_bound(testing::example_flight().quadrotor, 1 + 0.01 * (kGravity + 24.1));
  EXPECT_NEAR(miss.between, most * 1e-6 / 8, 1e-15);
  // Nearer than what the path may stray between steps.
  const FlightPathCheck near =
      check_flight_path(scene, testing::example_flight().quadrotor, {}, straight({0, 1.000001, 5}));
  EXPECT_EQ(near.reason, Reason::undecided);
  EXPECT_EQ(
      check_flight_path(scene, testing::example_flight().quadrotor, {}, straight({295.005, 0, 5}))
          .reason,
      Reason::bounds);
}

TEST(FlownPath, IsWiderWhereItTiltsTooMuch) {
  const auto scene = testing::scene_of({{Vec3(5, -1, 0), Vec3(6, 1, 10)}});
  Flight flight = straight({0, 1.2, 5});
  const TiltedVehicle vehicle{0.5, [](double tilt) { return Vec3::Constant(tilt); }};
  EXPECT_TRUE(check_flight_path(scene, testing::example_flight().quadrotor, vehicle, flight).clear);
  flight.tilt[55] = 0.6;
  EXPECT_EQ(check_flight_path(scene, testing::example_flight().quadrotor, vehicle, flight).reason,
            Reason::collision);
  flight.tilt[55] = 0;
  flight.tilt[80] = 0.6;  // past the box
  EXPECT_TRUE(check_flight_path(scene, testing::example_flight().quadrotor, vehicle, flight).clear);
}

TEST(Tube, IsClearExactlyWhileItIsThinnerThanTheWay) {
  const auto scene = testing::scene_of({{Vec3(4, 1, 0), Vec3(6, 2, 10)}});
  Trajectory t = testing::line({10, 0, 0}, 10);
  for (Vec3& p : t.segments[0].point) p.z() += 5;
  std::vector<double> radius(100, 0.99);
  EXPECT_TRUE(check_tube(scene, t, radius, 0.1).clear);
  radius.assign(100, 1.01);
  EXPECT_EQ(check_tube(scene, t, radius, 0.1).reason, Reason::collision);
  radius.assign(100, 0.5);
  radius[50] = 1.01;  // where it passes the box
  EXPECT_FALSE(check_tube(scene, t, radius, 0.1).clear);
  radius[50] = 0.5;
  radius[5] = 1.01;  // long before
  EXPECT_TRUE(check_tube(scene, t, radius, 0.1).clear);
}

TEST(Tube, IsNotClearWhereANumberIsNone) {
  const auto scene = testing::scene_of({{Vec3(4, 1, 0), Vec3(6, 2, 10)}});
  const Trajectory t = testing::line({10, 0, 0}, 10);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> radius(100, 0.5), wrong(100, nan), below(100, -0.5);
  EXPECT_THROW(check_tube(scene, t, wrong, 0.1), geom::InputError);
  EXPECT_THROW(check_tube(scene, t, below, 0.1), geom::InputError);
  EXPECT_THROW(check_tube(scene, t, std::vector<double>{}, 0.1), geom::InputError);
  for (const double period : {nan, 0.0, -1.0}) {
    EXPECT_THROW(check_tube(scene, t, radius, period), geom::InputError);
  }
  EXPECT_FALSE(check_tube(scene, Trajectory{}, radius, 0.1).clear);
}

}  // namespace
}  // namespace traj
