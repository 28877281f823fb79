#include "mission/mavlink/parameter_fence.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/formats/wpl.h"

namespace traj {
namespace {

// What refuses a mission 60 m high, some 111 m to the north of home, that an autopilot with these
// parameters flies; "" where it is within their fence.
std::string refusal_within(const std::string& parameters) {
  const AutopilotSettings settings = read_autopilot_settings(support::Text(parameters), "p.param");
  const Autopilot pilot = set_autopilot(settings, {px4(), ardupilot()}, "p.param").autopilot;
  const Mission mission = read_wpl(support::Text("QGC WPL 110\n"
                                                 "0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n"
                                                 "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t60\t1\n"
                                                 "2\t0\t3\t16\t3\t2\t0\t0\t47.001\t8\t60\t1\n"),
                                   "m.wpl");
  return support::refusal_of([&] {
    flown_mission(mission, {{47, 8, 400}, 0}, {.autopilots = {pilot}}, "m.wpl");
  });
}

TEST(ParameterFence, KeepsToTheHighestAltitude) {
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_ALT_MAX,50\n"),
            "m.wpl: item 1: expected at most 50 m above home, as FENCE_ALT_MAX says, found up to "
            "60.2 m: there the autopilot leaves its mission because of its fence");
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_ALT_MAX,70\n"), "");
  EXPECT_NE(refusal_within("NAV_ACC_RAD,2\nGF_MAX_VER_DIST,50\n")
                .find("item 1: expected at most 50 m above home, as GF_MAX_VER_DIST s"),
            std::string::npos);
}

TEST(ParameterFence, KeepsToTheCircle) {
  EXPECT_NE(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_RADIUS,100\n")
                .find("item 2: expected at most 100 m from home, as FENCE_RADIUS says,"),
            std::string::npos);
  EXPECT_EQ(refusal_within("RTL_ALT,1500\nFENCE_ENABLE,1\nFENCE_RADIUS,120\n"), "");
  EXPECT_NE(refusal_within("NAV_ACC_RAD,2\nGF_MAX_HOR_DIST,100\n")
                .find("item 2: expected at most 100 m from home, as GF_MAX_HOR_DIST sa"),
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

}  // namespace
}  // namespace traj
