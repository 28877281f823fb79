// What moves a camera.

#include "traj/flight/moving_vehicle.h"

#include <gtest/gtest.h>

namespace {

using geom::Axes;
using geom::Vec3;

traj::Trajectory bend() {
  traj::Trajectory out;
  traj::State a, b, c;
  b.position = {20, 5, 8};
  b.velocity = {3, 2, 0};
  c.position = {30, 30, 4};
  out.segments = {traj::hermite(a, b, 8), traj::hermite(b, c, 9)};
  return out;
}

TEST(MovingVehicle, OfATrajectoryIsTheSameInBothFrames) {
  traj::Trajectory swapped = bend();
  for (traj::Segment& s : swapped.segments) {
    for (Vec3& p : s.point) p = geom::to_enu(Axes::neu, p);
  }
  const traj::MovingVehicle enu("a", bend(), Axes::enu);
  const traj::MovingVehicle neu("a", swapped, Axes::neu);
  for (double t = 0; t <= enu.end(); t += 0.25) {
    EXPECT_NEAR((enu.pose(t).position - neu.pose(t).position).norm(), 0, 1e-9);
    EXPECT_NEAR((enu.pose(t).attitude - neu.pose(t).attitude).norm(), 0, 1e-9) << t;
  }
}

TEST(MovingVehicle, OfAFlightIsLinearBetweenItsRows) {
  traj::FlightLog log;
  log.id = "f";
  for (int i = 0; i < 3; ++i) {
    traj::FlightSample s;
    s.time = 1 + i;
    s.position = Vec3(10 * i, i * i, 5);
    s.attitude = Eigen::AngleAxisd(0.4 * i, Vec3::UnitZ());
    s.setpoint_position = s.position + Vec3(0, 0, 0.5 * i);
    log.samples.push_back(s);
  }
  const traj::MovingVehicle motion(log);
  EXPECT_EQ(motion.begin(), 1);
  EXPECT_EQ(motion.end(), 3);
  EXPECT_NEAR((motion.pose(1.5).position - Vec3(5, 0.5, 5)).norm(), 0, 1e-12);
  const Eigen::Matrix3d half = Eigen::AngleAxisd(0.6, Vec3::UnitZ()).toRotationMatrix();
  EXPECT_NEAR((motion.pose(2.5).attitude - half).norm(), 0, 1e-12);
  EXPECT_NEAR(motion.tracking_error(2.5), 0.75, 1e-12);
  EXPECT_EQ(motion.pose(99).position, log.samples.back().position);
  EXPECT_EQ(motion.pose(-1).position, log.samples.front().position);
}

}  // namespace
