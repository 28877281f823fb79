#include "traj/mission/mavlink/mission_time.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

// Steps through jerk, acceleration and speed: the same motion, by another way.
double stepped(double length, double speed, double acceleration, double jerk) {
  // The first half is flown up to the middle, then mirrored: find the peak speed that fits.
  const auto ramp = [&](double v) {  // seconds and metres from rest to v
    const double limited = acceleration * acceleration / jerk;
    const double t =
        v >= limited ? v / acceleration + acceleration / jerk : 2 * std::sqrt(v / jerk);
    return std::pair(t, v / 2 * t);
  };
  double low = 0;
  double high = speed;
  if (2 * ramp(speed).second > length) {
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (2 * ramp(middle).second > length ? high : low) = middle;
    }
  } else {
    low = speed;
  }
  const auto [seconds, metres] = ramp(low);
  return 2 * seconds + (length - 2 * metres) / low;
}

TEST(RestToRest, IsTheSCurve) {
  for (const double length : {0.01, 0.5, 3.0, 20.0, 80.0, 600.0}) {
    for (const double speed : {0.5, 3.0, 12.0}) {
      for (const double jerk : {0.5, 4.0, 30.0}) {
        EXPECT_NEAR(traj::rest_to_rest(length, speed, 3, jerk), stepped(length, speed, 3, jerk),
                    1e-6 * length + 1e-9)
            << length << ' ' << speed << ' ' << jerk;
      }
    }
  }
  EXPECT_EQ(traj::rest_to_rest(0, 5, 3, 4), 0);
}

traj::Mission mission_of(std::span<const geom::Vec3> points, traj::MissionOptions options) {
  return traj::make_mission(points, {{47, 8, 0}, 0, true}, options);
}

TEST(MissionTime, AddsLegsAndHolds) {
  const std::vector<geom::Vec3> points = {{0, 0, 10}, {100, 0, 10}, {100, 50, 10}};
  traj::MissionOptions options;
  options.speed = 5;
  options.hold = 3;
  const traj::Autopilot px4 = traj::px4();
  const traj::MissionTime time = traj::mission_time(mission_of(points, options), px4);
  EXPECT_EQ(time.waypoints, 3u);
  EXPECT_EQ(time.rests, 3u);
  const double legs = traj::rest_to_rest(100, 5, px4.acceleration, px4.jerk) +
                      traj::rest_to_rest(50, 5, px4.acceleration, px4.jerk);
  EXPECT_NEAR(time.seconds, legs + 9, 0.5);
}

TEST(MissionTime, APassedCornerIsNoRest) {
  const std::vector<geom::Vec3> points = {{0, 0, 10}, {100, 0, 10}, {200, 10, 10}};
  traj::MissionOptions options;
  options.speed = 5;
  const traj::MissionTime rests = traj::mission_time(mission_of(points, options), traj::px4());
  options.passed = {false, true, false};
  const traj::MissionTime passed = traj::mission_time(mission_of(points, options), traj::px4());
  EXPECT_EQ(passed.rests, rests.rests - 1);
  EXPECT_LT(passed.seconds, rests.seconds - options.hold);
}

TEST(MissionTime, ClimbsNoFasterThanTheAutopilot) {
  const std::vector<geom::Vec3> points = {{0, 0, 10}, {1, 0, 70}};
  traj::MissionOptions options;
  options.speed = 12;
  const traj::Autopilot px4 = traj::px4();  // 3 m/s up
  EXPECT_GT(traj::mission_time(mission_of(points, options), px4).seconds, 60 / px4.climb);
}

}  // namespace
