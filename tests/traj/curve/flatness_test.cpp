#include "traj/curve/flatness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_city.h"
#include "traj/curve/yaw.h"
#include "traj/proof/limits.h"

namespace {

using geom::Axes;
using traj::FlatState;
using traj::Heading;
using traj::State;
using traj::Vec3;

TEST(Flatness, HoverIsUprightWithTheWeightAsThrust) {
  const FlatState flat = traj::flat_state({}, {0.5, 0.25});
  EXPECT_DOUBLE_EQ(flat.thrust, traj::kGravity);
  EXPECT_NEAR((flat.attitude.col(2) - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((flat.attitude.col(0) - Vec3(std::cos(0.5), std::sin(0.5), 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((flat.body_rate - Vec3(0, 0, 0.25)).norm(), 0, 1e-15);
}

TEST(Flatness, AcceleratingForwardAtOneGPutsTheNoseDownBy45Degrees) {
  State state;
  state.acceleration = {0, traj::kGravity, 0};  // north, and looking north
  const FlatState flat = traj::flat_state(state, {1.5707963267948966, 0});
  const double half = std::sqrt(0.5);
  EXPECT_NEAR((flat.attitude.col(0) - Vec3(0, half, -half)).norm(), 0, 1e-15);
  EXPECT_NEAR((flat.attitude.col(1) - Vec3(-1, 0, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(flat.thrust, traj::kGravity / half, 1e-14);
}

TEST(Flatness, FreeFallIsUpright) {
  State state;
  state.acceleration = {0, 0, -traj::kGravity};
  const FlatState flat = traj::flat_state(state, {1, 2});
  EXPECT_EQ(flat.attitude.col(2), Vec3::UnitZ());
  EXPECT_EQ(flat.body_rate, Vec3(0, 0, 2));
}

TEST(Flatness, AttitudeHasTheForceAndSeenFromAboveTheHeading) {
  support::Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 force(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(1, 6));
    const double yaw = random.uniform(-4, 4);
    const Eigen::Matrix3d r = traj::attitude_along(force, yaw);
    const Vec3 x = r.col(0);
    EXPECT_LT((r.col(2) - force.normalized()).norm(), 1e-12);
    EXPECT_LT((x.head<2>().normalized() - Vec3(std::cos(yaw), std::sin(yaw), 0).head<2>()).norm(),
              1e-12);
    EXPECT_NEAR(r.determinant(), 1, 1e-12);
  }
}

TEST(Flatness, AForceToTheSideOfTheHeadingHasAnAttitudeToo) {
  const Eigen::Matrix3d r = traj::attitude_along(Vec3::UnitY(), 0);
  EXPECT_EQ(r.col(0), Vec3::UnitX());
  EXPECT_EQ(r.col(2), Vec3::UnitY());
  EXPECT_EQ(r.determinant(), 1);
  EXPECT_TRUE(traj::body_rates_along(Vec3::UnitY(), {1, 2, 3}, {0, 1}).allFinite());
  // Just above it the attitude is nearly the same.
  EXPECT_LT((traj::attitude_along({0, 1, 1e-6}, 0) - r).norm(), 1e-5);
}

traj::Trajectory random_trajectory(support::Random& random) {
  traj::Trajectory out;
  State from;
  for (int i = 0; i < 3; ++i) {
    State to;
    const auto vector = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most),
                  random.uniform(-most, most));
    };
    to.position = from.position + vector(15);
    to.velocity = vector(3);
    to.acceleration = vector(2);
    to.jerk = vector(2);
    out.segments.push_back(traj::hermite(from, to, random.uniform(4, 6)));
    from = to;
  }
  traj::add_yaw({}, out);
  return out;
}

FlatState at(const traj::Trajectory& trajectory, Axes axes, double t) {
  return traj::flat_state(traj::to_enu(axes, traj::evaluate(trajectory, t)),
                          traj::heading_at(trajectory, axes, t));
}

// Body rates by central differences of the attitude, thrust and heading by their definitions.
TEST(FlatnessProperty, RatesAreTheDerivativeOfTheAttitude) {
  support::Random random(11);
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    const traj::Trajectory trajectory = random_trajectory(random);
    const Axes axes = round % 2 ? Axes::neu : Axes::enu;
    const double t = random.uniform(0.01, traj::duration(trajectory) - 0.01);
    const double h = 1e-5;
    const FlatState flat = at(trajectory, axes, t);
    const Eigen::Matrix3d slope =
        (at(trajectory, axes, t + h).attitude - at(trajectory, axes, t - h).attitude) / (2 * h);
    const Eigen::Matrix3d spin = flat.attitude.transpose() * slope;
    const Vec3 rate(spin(2, 1), spin(0, 2), spin(1, 0));
    SCOPED_TRACE(testing::Message() << "seed 11, round " << round);
    EXPECT_LT((flat.attitude.transpose() * flat.attitude - Eigen::Matrix3d::Identity()).norm(),
              1e-12);
    EXPECT_NEAR(flat.attitude.determinant(), 1, 1e-12);
    const Heading heading = traj::heading_at(trajectory, axes, t);
    const Vec3 x = flat.attitude.col(0);
    const double back = flat.attitude(2, 2) > 0 ? 0 : 3.141592653589793;  // upside down
    EXPECT_NEAR(
        std::remainder(std::atan2(x.y(), x.x()) - heading.yaw + back, 2 * 3.141592653589793), 0,
        1e-9);
    EXPECT_LT((flat.body_rate - rate).norm(), 1e-4 * (1 + rate.norm()));
    compared += rate.norm() > 0.1;
  }
  EXPECT_GT(compared, 100);
}

TEST(FlatnessProperty, HeadingAndItsRateAreThoseOfTheYaw) {
  support::Random random(12);
  const traj::Trajectory trajectory = random_trajectory(random);
  const double end = traj::duration(trajectory);
  for (int i = 0; i < 100; ++i) {
    const double t = random.uniform(0.01, end - 0.01);
    const Heading enu = traj::heading_at(trajectory, Axes::enu, t);
    const Heading neu = traj::heading_at(trajectory, Axes::neu, t);
    EXPECT_NEAR(enu.yaw + neu.yaw, 1.5707963267948966, 1e-12);
    EXPECT_NEAR(enu.rate, -neu.rate, 1e-12);
    const double h = 1e-5;
    EXPECT_NEAR((traj::heading_at(trajectory, Axes::enu, t + h).yaw -
                 traj::heading_at(trajectory, Axes::enu, t - h).yaw) /
                    (2 * h),
                enu.rate, 1e-6);
  }
  EXPECT_EQ(traj::heading_at(trajectory, Axes::enu, end + 1).yaw,
            traj::heading_at(trajectory, Axes::enu, end).yaw);
  EXPECT_EQ(traj::heading_at(trajectory, Axes::enu, -1).yaw, trajectory.segments[0].yaw->front());
}

}  // namespace
