#include "traj/figure/motion_profile.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace {

TEST(MotionProfile, ShowsUnitsAndLimitsOnce) {
  traj::TrajectoryRecord record;
  record.id = "a<b";
  record.status = traj::TrajectoryStatus::solved;
  traj::State end;
  end.position = {10, 0, 3};
  record.trajectory.segments = {traj::hermite({}, end, 5)};
  record.limits[geom::Limit::speed] = 8;
  record.limits[geom::Limit::tilt] = 0.5;
  const std::string svg = traj::figure::motion_profile(record);
  for (const char* words :
       {"position, m", "speed, m/s", "acceleration, m/s\u00b2", "jerk, m/s\u00b3", "thrust/mass",
        "snap, m/s\u2074",
        "\u222b |jerk|\u00b2 dt = ", "\u222b |snap|\u00b2 dt = ", "m\u00b2/s\u2077", "tilt, \u00b0",
        "time, s", "vmax 8", "tilt 28.65", "a&lt;b: 5.00 s", "east", "north"}) {
    EXPECT_TRUE(support::says(svg, words)) << words;
  }
  EXPECT_FALSE(support::says(svg, "amax"));
  EXPECT_FALSE(support::says(svg, "nan"));
}

TEST(MotionProfile, SaysHowMuchFasterAnyOtherCouldBe) {
  traj::TrajectoryRecord record;
  record.id = "a";
  record.status = traj::TrajectoryStatus::solved;
  traj::State end;
  end.position = {10, 0, 0};
  record.trajectory.segments = {traj::hermite({}, end, 5)};
  record.limits[geom::Limit::speed] = 4;
  EXPECT_FALSE(support::says(traj::figure::motion_profile(record), "slower"));
  record.bound = 10;
  record.duration_bound = 2.4;
  EXPECT_TRUE(
      support::says(traj::figure::motion_profile(record), "at most 100.1 % slower than any"));
  record.duration_bound = 2.6;  // 10 m at 4 m/s take 2.5 s
  EXPECT_FALSE(support::says(traj::figure::motion_profile(record), "slower"));
}

}  // namespace
