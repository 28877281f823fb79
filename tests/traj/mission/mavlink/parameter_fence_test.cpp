#include "mission/mavlink/parameter_fence.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/formats/wpl.h"

namespace traj {
namespace {

// What refuses a mission that an autopilot with these parameters flies; "" where it is within their
// fence. Empty: with ArduPilot's own.
std::string refusal_of(const std::string& items, const std::string& parameters) {
  Autopilot pilot = ardupilot();
  if (!parameters.empty()) {
    const AutopilotSettings settings =
        read_autopilot_settings(support::Text(parameters), "p.param");
    pilot = set_autopilot(settings, {px4(), ardupilot()}, "p.param").autopilot;
  }
  const Mission mission = read_wpl(
      support::Text("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n" + items), "m.wpl");
  return support::refusal_of([&] {
    flown_mission(mission, {{47, 8, 400}, 0}, {.autopilots = {pilot}}, "m.wpl");
  });
}

// Of a mission 60 m high, some 111 m to the north of home.
std::string refusal_within(const std::string& parameters) {
  return refusal_of(
      "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t60\t1\n"
      "2\t0\t3\t16\t3\t2\t0\t0\t47.001\t8\t60\t1\n",
      parameters);
}

TEST(ParameterFence, KeepsToTheHighestAltitude) {
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_ALT_MAX,50\n"),
            "m.wpl: item 1: expected less than 50 m above home, as FENCE_ALT_MAX says, found up to "
            "60.2 m: there the autopilot leaves its mission because of its fence");
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_ALT_MAX,70\n"), "");
  EXPECT_NE(refusal_within("NAV_ACC_RAD,2\nGF_MAX_VER_DIST,50\n")
                .find("item 1: expected less than 50 m above home, as GF_MAX_VER_DIST s"),
            std::string::npos);
}

TEST(ParameterFence, KeepsToTheCircle) {
  EXPECT_NE(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_RADIUS,100\n")
                .find("item 2: expected less than 100 m from home, as FENCE_RADIUS says,"),
            std::string::npos);
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_RADIUS,120\n"), "");
  EXPECT_NE(refusal_within("NAV_ACC_RAD,2\nGF_MAX_HOR_DIST,100\n")
                .find("item 2: expected less than 100 m from home, as GF_MAX_HOR_DIST sa"),
            std::string::npos);
}

TEST(ParameterFence, HoldsWhereItActs) {
  const std::string low = "FENCE_ALT_MAX,50\nFENCE_RADIUS,10\n";
  EXPECT_EQ(refusal_within("RTL_ALT,1500\n" + low), "") << "off";
  EXPECT_NE(refusal_within("RTL_ALT,1500\nFENCE_AUTOENABLE,1\n" + low), "");
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_ACTION,0\n" + low), "")
      << "only reports";
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_TYPE,4\n" + low), "") << "polygons";
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nGF_ACTION,1\nGF_MAX_VER_DIST,50\n"), "") << "only warns";
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nGF_MAX_VER_DIST,0\n"), "") << "none";
}

TEST(ParameterFence, HoldsWhereItStraysToo) {
  // 111.2 m away: a stop from 10 m/s is overshot by 1.3 m.
  const std::string radius = "RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_RADIUS,";
  EXPECT_NE(refusal_within(radius + "112\n").find("item 2: expected less than 112 m from home"),
            std::string::npos);
  EXPECT_NE(refusal_within(radius + "112\n").find("m where it strays: "), std::string::npos);
  EXPECT_EQ(refusal_within(radius + "114\n"), "");
}

TEST(ParameterFence, HoldsWhereAnItemSwitchesItOn) {
  const auto flown = [](const char* action, const char* height, const std::string& parameters) {
    return refusal_of(std::string("1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t60\t1\n"
                                  "2\t0\t2\t207\t") +
                          action +
                          "\t0\t0\t0\t0\t0\t0\t1\n"
                          "3\t0\t3\t16\t3\t2\t0\t0\t47.001\t8\t" +
                          height + "\t1\n",
                      parameters);
  };
  EXPECT_EQ(flown("1", "60", ""), "");
  EXPECT_NE(flown("1", "110", "")
                .find("item 3: expected less than 100 m above home, as FENCE_ALT_"
                      "MAX says, found up to 110.2 m: there the autopilot leaves "
                      "its mission because of its fence, which an item of command "
                      "207 switches on"),
            std::string::npos);
  EXPECT_EQ(flown("0", "110", ""), "") << "off";
  EXPECT_NE(flown("2", "110", ""), "") << "on until 4.5";
  EXPECT_EQ(flown("1", "110", "RTL_ALT,1500\nFENCE_ALT_MAX,150\n"), "");
  EXPECT_NE(flown("1", "60", "RTL_ALT,1500\nFENCE_RADIUS,50\n"), "");
  EXPECT_EQ(flown("1", "60", "RTL_ALT,1500\nFENCE_RADIUS,50\nFENCE_ACTION,0\n"), "");
  EXPECT_EQ(flown("1", "110", "NAV_ACC_RAD,2\n"), "") << "PX4 has none";
}

TEST(ParameterFence, KeepsAboveTheLowestAltitudeOnceItWasAbove) {
  const auto flown = [](const char* first, const char* then, const std::string& parameters) {
    return refusal_of(std::string("1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t") + first +
                          "\t1\n"
                          "2\t0\t3\t16\t3\t2\t0\t0\t47.001\t8\t" +
                          then +
                          "\t1\n"
                          "3\t0\t3\t21\t0\t0\t0\t0\t47.001\t8\t0\t1\n",
                      parameters);
  };
  const std::string lowest = "RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_TYPE,8\nFENCE_ALT_MIN,15\n";
  EXPECT_EQ(flown("30", "20", lowest), "") << "it may land";
  EXPECT_EQ(flown("30", "10", lowest),
            "m.wpl: item 2: expected more than 15 m above home, as FENCE_ALT_MIN says, found down "
            "to 9.8 m: there the autopilot leaves its mission because of its fence");
  EXPECT_EQ(flown("10", "30", lowest), "") << "it is on from where the vehicle was above it";
  EXPECT_EQ(flown("30", "10", "RTL_ALT,1500\nFENCE_TYPE,8\nFENCE_ALT_MIN,15\n"), "") << "off";
  EXPECT_EQ(flown("30", "10", "RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_TYPE,7\nFENCE_ALT_MIN,15\n"),
            "");
}

TEST(ParameterFence, ActsEarlyWherePx4ForeseesThatItLeavesIt) {
  // At 5 m/s it takes itself to go on by 23.2 m, and by 12 m up at 3 m/s.
  const std::string early = "NAV_ACC_RAD,2\nGF_PREDICT,1\n";
  EXPECT_EQ(refusal_within(early), "") << "there is none";
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nGF_MAX_HOR_DIST,115\n"), "");
  EXPECT_NE(refusal_within(early + "GF_MAX_HOR_DIST,132\n"), "");
  EXPECT_EQ(refusal_within(early + "GF_MAX_HOR_DIST,140\n"), "");
  EXPECT_NE(refusal_within(early + "GF_MAX_VER_DIST,70\n"), "");
  EXPECT_EQ(refusal_within(early + "GF_MAX_VER_DIST,75\n"), "");
  EXPECT_EQ(refusal_within(early + "GF_MAX_HOR_DIST,115\nGF_ACTION,1\n"), "") << "only warns";
}

TEST(ParameterFence, HoldsItemsThatPx4WouldFlyLower) {
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nLNDMC_ALT_MAX,50\n"),
            "m.wpl: item 1: expected at most 50 m above home, as LNDMC_ALT_MAX says, found 60.0 m: "
            "PX4 until 1.14 flies no higher than that, and newer versions have no such parameter");
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nLNDMC_ALT_MAX,60\n"), "");
  EXPECT_EQ(refusal_within("NAV_ACC_RAD,2\nLNDMC_ALT_MAX,-1\n"), "");
}

}  // namespace
}  // namespace traj
