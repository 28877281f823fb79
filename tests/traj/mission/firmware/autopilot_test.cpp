#include "traj/mission/firmware/autopilot.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Autopilots, AreThoseOfTheWord) {
  ASSERT_EQ(autopilots_of("any")->size(), 2u);
  EXPECT_EQ(names_of(*autopilots_of("any")), "px4:1.11-1.17, ardupilot:4.3-4.7");
  EXPECT_EQ(names_of(*autopilots_of("px4:1.17")), "px4:1.17");
  EXPECT_EQ(autopilots_of("ardupilot:4.5")->front().firmware, Firmware::ardupilot);
  for (const char* word : {"", "px4:", "px4:1.10", "px4:2.0", "ardupilot:1.17", "PX4", "dji"}) {
    EXPECT_FALSE(autopilots_of(word)) << word;
  }
}

TEST(Autopilots, DoNotFollowALegToATightRadiusSince112) {
  EXPECT_EQ(px4("1.11").least_radius, 0);
  EXPECT_EQ(px4("1.12").least_radius, kLeastLineRadius);
  EXPECT_EQ(px4().least_radius, kLeastLineRadius) << "any of them";
  EXPECT_EQ(ardupilot().least_radius, 0);
}

TEST(Autopilots, OvershootByTheDragOfTheAirframe) {
  Autopilot draggy = px4();
  set_drag(draggy, 1);
  Autopilot sleek = px4();
  set_drag(sleek, 0.1);
  EXPECT_EQ(px4().drag, kUsualDrag);
  EXPECT_GT(draggy.overshoot_time, px4().overshoot_time);
  EXPECT_EQ(sleek.overshoot_time, 0);
  EXPECT_GT(draggy.fall, sleek.fall);
  Autopilot ardu = ardupilot();
  set_drag(ardu, 0);
  EXPECT_EQ(ardu.overshoot_time, 0.12) << "no less than it was flown with";
  set_drag(ardu, 1);
  EXPECT_EQ(ardu.overshoot_time, 0.2);
}

TEST(SCurveLength, IsThatOfAccelerationAndJerk) {
  EXPECT_DOUBLE_EQ(s_curve_length(ardupilot(), 8), 64 / 5.0 + 8 * 2.5 / 2);
  EXPECT_EQ(s_curve_length(ardupilot(), 0), 0);
}

}  // namespace
}  // namespace traj
