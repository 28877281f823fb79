#include "traj/mission/firmware/autopilot_settings.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/mission/ulog/ulog_bytes.h"

namespace traj {
namespace {

AutopilotSettings read(const std::string& text) {
  return read_autopilot_settings(support::Text(text), "p");
}

SetAutopilot set(const std::string& text, const std::string& asked = "any") {
  return set_autopilot(read(text), *autopilots_of(asked), "p");
}

std::string refusal(const std::string& text, const std::string& asked = "any") {
  return support::refusal_of([&] { set(text, asked); });
}

const std::string kPx4 =
    "# Onboard parameters for Vehicle 1\n#\n# Stack: PX4 Pro\n# Vehicle: Multi-Rotor\n"
    "# Version: 1.15.4 \n#\n# Vehicle-Id Component-Id Name Value Type\n"
    "1\t1\tNAV_ACC_RAD\t2.000000000000000000\t9\n1\t1\tRTL_CONE_ANG\t65\t6\n"
    "1\t1\tMC_ROLL_P\t6.5\t9\n1\t1\tRTL_RETURN_ALT\t30\t9\n";

TEST(AutopilotSettings, AreReadAsQGroundControlWritesThem) {
  const SetAutopilot made = set(kPx4);
  EXPECT_EQ(made.autopilot.name, "px4:1.15");
  EXPECT_EQ(made.autopilot.acceptance, 2);
  EXPECT_EQ(made.autopilot.return_height, 30);
  EXPECT_NEAR(made.autopilot.return_slope, 0.4663, 1e-4);
  EXPECT_EQ(made.autopilot.height_acceptance, 0.8);
  EXPECT_EQ(made.assumed.front(), "NAV_MC_ALT_RAD 0.8");
  EXPECT_EQ(made.assumed.back(), "RTL_TYPE 0");
  EXPECT_EQ(set(kPx4, "px4:1.17").autopilot.name, "px4:1.17") << "as asked";
}

TEST(AutopilotSettings, KnowArduPilotsCentimetresAndMetres) {
  const Autopilot old = set("WPNAV_RADIUS,300\nRTL_ALT 4500\nWPNAV_SPEED_UP\t400\n").autopilot;
  EXPECT_EQ(old.name, "ardupilot:4.3-4.7");
  EXPECT_EQ(old.acceptance, 3);
  EXPECT_EQ(old.return_height, 45);
  EXPECT_EQ(old.climb, 4);
  const Autopilot metres = set("WP_RADIUS_M,3\nRTL_ALT_M,45\nWP_SPD_UP,4\n").autopilot;
  EXPECT_EQ(metres.acceptance, old.acceptance);
  EXPECT_EQ(metres.return_height, old.return_height);
  EXPECT_EQ(metres.climb, old.climb);
  EXPECT_EQ(refusal("WP_RADIUS_M,3\nRTL_ALT,4500\n"),
            "p: expected ArduPilot's parameters in centimetres (WPNAV_RADIUS …) or in metres "
            "(WP_RADIUS_M …), found both");
}

TEST(AutopilotSettings, KnowWhatGoesBeforeOthers) {
  const Autopilot px = set("NAV_ACC_RAD,2\nMPC_Z_VEL_ALL,5\nMPC_XY_VEL_ALL,-10\n").autopilot;
  EXPECT_EQ(px.climb, 5);
  EXPECT_EQ(px.descent, 5);
  EXPECT_EQ(px.speed, 5) << "the default";
  EXPECT_EQ(set("WPNAV_SPEED,500\nRTL_SPEED,1200\n").autopilot.speed, 12);
}

TEST(AutopilotSettings, SayWhereAReturnMayGo) {
  EXPECT_TRUE(set("RTL_TYPE,0\nNAV_ACC_RAD,2\n").autopilot.returns_home);
  EXPECT_FALSE(set("RTL_TYPE,1\nNAV_ACC_RAD,2\n").autopilot.returns_home);
  EXPECT_EQ(set("RTL_CONE_ANG,0\nNAV_ACC_RAD,2\n").autopilot.return_slope, 0);
}

TEST(AutopilotSettings, SayNearWhereAReturnStaysLowAndHowItDescends) {
  const Autopilot px = set("RTL_MIN_DIST,40\nRTL_DESCEND_ALT,12\n", "px4:1.17").autopilot;
  EXPECT_EQ(px.return_near, 40);
  EXPECT_EQ(px.return_descend, 12);
  EXPECT_FALSE(px.descends_aslant);
  EXPECT_TRUE(set("RTL_LAND_DELAY,2\nRTL_MIN_DIST,40\n", "px4:1.17").autopilot.descends_aslant);
  EXPECT_TRUE(set("RTL_MIN_DIST,40\n", "px4:1.15").autopilot.descends_aslant) << "always";
}

TEST(AutopilotSettings, SayWhichRallyPointsCount) {
  const Autopilot usual = set("RTL_ALT,1500\n").autopilot;
  EXPECT_EQ(usual.rally_limit, 300);
  EXPECT_TRUE(usual.home_is_a_place);
  const Autopilot other = set("RALLY_LIMIT_KM,2\nRALLY_INCL_HOME,0\n").autopilot;
  EXPECT_EQ(other.rally_limit, 2000);
  EXPECT_FALSE(other.home_is_a_place);
  EXPECT_EQ(set("RTL_ALT,1500\n").assumed.back(), "RALLY_INCL_HOME 1");
}

TEST(AutopilotSettings, KnowNoWayOfAReturnRoundFencesOverTerrainOrToABeacon) {
  for (const char* name :
       {"RTL_ALT_TYPE", "OA_TYPE", "PLND_ENABLED", "RTL_ALT_FINAL", "RTL_ALT_FINAL_M"}) {
    EXPECT_TRUE(set(std::string("RTL_ALT,1500\n") + name + ",0\n").autopilot.returns_home);
    EXPECT_FALSE(set(std::string("RTL_ALT,1500\n") + name + ",1\n").autopilot.returns_home);
  }
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nRTL_PLD_MD,1\n").autopilot.returns_home);
}

TEST(AutopilotSettings, SayWhetherALostLinkMakesItReturn) {
  const auto returns = [](const std::string& text) { return set(text).autopilot.returns_if_lost; };
  EXPECT_TRUE(returns("NAV_ACC_RAD,2\n")) << "nothing is said";
  EXPECT_TRUE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nNAV_DLL_ACT,0\n")) << "one of two links";
  EXPECT_FALSE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,1\nNAV_DLL_ACT,0\n"));
  EXPECT_FALSE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,3\n"));
  EXPECT_TRUE(returns("RTL_ALT,1500\nFS_THR_ENABLE,1\n"));
  EXPECT_FALSE(returns("RTL_ALT,1500\nFS_THR_ENABLE,3\n"));
  EXPECT_FALSE(returns("RTL_ALT,1500\nFS_THR_ENABLE,0\nFS_GCS_ENABLE,4\n"));
}

TEST(AutopilotSettings, SayWhetherAMissionGoesOnWithoutALink) {
  const auto returns = [](const std::string& text) { return set(text).autopilot.returns_if_lost; };
  EXPECT_FALSE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nCOM_RCL_EXCEPT,1\n"));
  EXPECT_FALSE(returns("NAV_ACC_RAD,2\nCOM_RCL_EXCEPT,5\n"));
  EXPECT_TRUE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nCOM_RCL_EXCEPT,6\n")) << "other modes";
  EXPECT_TRUE(returns("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nNAV_DLL_ACT,2\nCOM_RCL_EXCEPT,1\n"));
  EXPECT_FALSE(returns("NAV_ACC_RAD,2\nNAV_DLL_ACT,2\nCOM_DLL_EXCEPT,1\n"));
  EXPECT_FALSE(returns("RTL_ALT,1500\nFS_THR_ENABLE,1\nFS_OPTIONS,17\n"));
  EXPECT_TRUE(returns("RTL_ALT,1500\nFS_THR_ENABLE,1\nFS_OPTIONS,18\n")) << "of the other link";
  EXPECT_FALSE(returns("RTL_ALT,1500\nFS_GCS_ENABLE,1\nFS_OPTIONS,3\n"));
}

TEST(AutopilotSettings, HaveTheFastestDescentAndClimb) {
  EXPECT_EQ(set("RTL_ALT,1500\nLAND_SPEED,50\n").autopilot.descent, 1.5);
  EXPECT_EQ(set("RTL_ALT,1500\nLAND_SPEED,200\n").autopilot.descent, 2);
  EXPECT_EQ(set("RTL_ALT,1500\nLAND_SPEED_HIGH,400\n").autopilot.descent, 4);
  EXPECT_EQ(set("RTL_ALT_M,15\nLAND_SPD_HIGH_MS,4\n").autopilot.descent, 4);
  EXPECT_EQ(set("NAV_ACC_RAD,2\nMPC_LAND_SPEED,2\nMPC_TKO_SPEED,5\n").autopilot.descent, 2);
  EXPECT_EQ(set("NAV_ACC_RAD,2\nMPC_LAND_SPEED,2\nMPC_TKO_SPEED,5\n").autopilot.climb, 5);
}

TEST(AutopilotSettings, SayWhatLeavesAMissionsWay) {
  EXPECT_TRUE(set("RTL_ALT,1500\n").autopilot.keeps_to_legs);
  EXPECT_FALSE(set("RTL_ALT,1500\nOA_TYPE,2\n").autopilot.keeps_to_legs);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nCOM_OBS_AVOID,1\n").autopilot.keeps_to_legs);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nCOM_OBS_AVOID,1\n").autopilot.returns_home);
  EXPECT_TRUE(set("RTL_ALT,1500\nPLND_ENABLED,0\n").autopilot.lands_below);
  EXPECT_FALSE(set("RTL_ALT,1500\nPLND_ENABLED,1\n").autopilot.lands_below);
}

TEST(AutopilotSettings, SayWhatStopsDescentsAndClimbsToHold) {
  EXPECT_TRUE(set("NAV_ACC_RAD,2\nNAV_MIN_GND_DIST,-1\n").autopilot.keeps_to_legs);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nNAV_MIN_GND_DIST,5\n").autopilot.keeps_to_legs);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nNAV_MIN_LTR_ALT,40\n").autopilot.climbs_to_hold);
  EXPECT_TRUE(set("NAV_ACC_RAD,2\nMIS_LTRMIN_ALT,40\n").autopilot.climbs_to_hold);
  EXPECT_TRUE(set("NAV_ACC_RAD,2\nRTL_LAND_DELAY,5\n").autopilot.returns_home);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nRTL_LAND_DELAY,-1\n").autopilot.returns_home)
      << "it never lands";
}

TEST(AutopilotSettings, HaveTheAccelerationThatAResponseMakes) {
  const Autopilot as_said = set("MPC_ACC_HOR,3\nSYS_VEHICLE_RESP,-0.4\n").autopilot;
  EXPECT_EQ(as_said.acceleration, 3);
  const Autopilot slow = set("MPC_ACC_HOR,3\nSYS_VEHICLE_RESP,0\n").autopilot;
  EXPECT_EQ(slow.acceleration, 1);
  EXPECT_EQ(slow.jerk, 1);
  EXPECT_EQ(set("NAV_ACC_RAD,2\nSYS_VEHICLE_RESP,0.5\n").autopilot.acceleration, 4.5);
}

TEST(AutopilotSettings, KnowThatARemoteControlThatIsOffIsNotLost) {
  EXPECT_TRUE(set("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nCOM_RC_IN_MODE,3\n").autopilot.returns_if_lost);
  EXPECT_FALSE(set("NAV_ACC_RAD,2\nNAV_RCL_ACT,2\nCOM_RC_IN_MODE,4\n").autopilot.returns_if_lost);
  EXPECT_TRUE(set("NAV_ACC_RAD,2\nNAV_DLL_ACT,2\nCOM_RC_IN_MODE,4\n").autopilot.returns_if_lost);
}

TEST(AutopilotSettings, SayHowHighAFenceLetsAReturnClimb) {
  const std::string height = "RTL_ALT,1500\nFENCE_ALT_MAX,50\nFENCE_MARGIN,3\n";
  EXPECT_FALSE(set(height).autopilot.fence.return_ceiling) << "it is off";
  EXPECT_EQ(set(height + "FENCE_ENABLE,1\n").autopilot.fence.return_ceiling, 47);
  EXPECT_TRUE(set(height + "FENCE_ENABLE,1\n").autopilot.rally_in_fence);
  EXPECT_FALSE(set(height + "FENCE_ENABLE,1\nFENCE_TYPE,6\n").autopilot.fence.return_ceiling);
  EXPECT_FALSE(set(height + "FENCE_AUTOENABLE,1\n").autopilot.returns_home);
}

TEST(AutopilotSettings, SayHowTerrainIsFollowed) {
  const std::string any = "RTL_ALT,1500\n";
  const Autopilot usual = set(any).autopilot;
  EXPECT_EQ(usual.terrain_spacing, 100);
  EXPECT_EQ(usual.terrain_lag, 10);
  EXPECT_TRUE(usual.follows_terrain);
  EXPECT_EQ(set(any + "TERRAIN_SPACING,30\n").autopilot.terrain_spacing, 30);
  EXPECT_EQ(set(any + "WPNAV_TER_MARGIN,5\n").autopilot.terrain_lag, 5);
  EXPECT_FALSE(set(any + "TERRAIN_ENABLE,0\n").autopilot.follows_terrain);
  EXPECT_FALSE(set(any + "TERRAIN_OFS_MAX,0\n").autopilot.follows_terrain);
  EXPECT_TRUE(set(any + "TERRAIN_OFS_MAX,15\n").autopilot.follows_terrain);
  EXPECT_FALSE(set(any + "RNGFND1_TYPE,0\nRNGFND2_TYPE,8\n").autopilot.follows_terrain)
      << "a rangefinder goes before its terrain";
  EXPECT_TRUE(set(any + "RNGFND2_TYPE,8\nWPNAV_RFND_USE,0\n").autopilot.follows_terrain);
  EXPECT_NE(refusal(any + "TERRAIN_SPACING,0\n"), "");
}

TEST(AutopilotSettings, RefuseOtherVehiclesAndVersions) {
  EXPECT_EQ(refusal("WPNAV_RADIUS,200\nCRUISE_SPEED,2\n"),
            "p: expected parameters of a multirotor, found CRUISE_SPEED, which another class of "
            "vehicles has");
  EXPECT_EQ(refusal("NAV_ACC_RAD,2\nMAV_TYPE,1\n"),
            "p: expected MAV_TYPE of a multirotor (2, 3, 4, 13, 14, 15, 29), found 1");
  EXPECT_EQ(refusal("# Vehicle: Fixed Wing\nNAV_ACC_RAD,2\n"),
            "p: expected parameters of a multirotor, found those of \"Fixed Wing\"");
  EXPECT_EQ(refusal("# Version: 1.9.2\nNAV_ACC_RAD,2\n"),
            "p: expected parameters of a version that is modelled (" + px4().name +
                "), found version 1.9; --autopilot px4 takes all of them for possible");
  EXPECT_EQ(refusal("NAV_ACC_RAD,2\n", "ardupilot"),
            "p: expected parameters of ardupilot:4.3-4.7, found those of px4");
  EXPECT_EQ(refusal("NAV_ACC_RAD,2\nWPNAV_RADIUS,200\n"),
            "p: expected parameters of PX4 or of ArduPilot Copter, found both");
  EXPECT_EQ(refusal("MC_ROLL_P,6.5\n").substr(0, 32), "p: expected parameters of PX4 (N");
}

std::string in_log(const std::string& name, float value) {
  const std::string key = "float " + name;
  return ulog_message('P', static_cast<char>(key.size()) + key + bytes_of(value));
}

TEST(AutopilotSettings, AreReadFromALogThatHasThemAll) {
  const std::string begin = ulog_head() + in_log("NAV_ACC_RAD", 2);
  const std::string rest = in_log("RTL_RETURN_ALT", 60);
  const std::string data = ulog_message('F', "p:uint64_t timestamp;float x;") + ulog_topic("p", 7);
  EXPECT_EQ(set(begin + rest + data).autopilot.return_height, 60);
  const std::string why =
      "p: expected a log that goes on after its parameters, found one that ends among them: those "
      "that are missing would count as the firmware's";
  EXPECT_EQ(refusal(begin), why);
  EXPECT_EQ(refusal(begin + rest.substr(0, 9)), why);
}

TEST(AutopilotSettings, RefuseWhatIsNoParameter) {
  EXPECT_EQ(refusal("NAV_ACC_RAD,200.5\n"), "p: NAV_ACC_RAD must be from 0.05 to 200, found 200.5");
  EXPECT_EQ(refusal("NAV_ACC_RAD,-1\n"), "p: NAV_ACC_RAD must be from 0.05 to 200, found -1");
  EXPECT_EQ(refusal("NAV_ACC_RAD,nan\n"), "p:1: NAV_ACC_RAD must be a finite number, found nan");
  EXPECT_EQ(refusal("NAV_ACC_RAD,2\nNAV_ACC_RAD,3\n"),
            "p:2: expected one value of NAV_ACC_RAD, found 3 after 2");
  EXPECT_EQ(refusal("NAV_ACC_RAD\n"),
            "p:1: expected a parameter (its name and its value, or five columns of "
            "QGroundControl), found \"NAV_ACC_RAD\"");
  EXPECT_EQ(refusal("# nothing\n"), "p: expected parameters, found none");
}

}  // namespace
}  // namespace traj
