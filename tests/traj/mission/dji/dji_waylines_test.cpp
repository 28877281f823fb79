#include "mission/dji/dji_waylines.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/mission/dji/dji_examples.h"

namespace traj {
namespace {

using testing::dji_config;
using testing::dji_folder;
using testing::dji_leg;
using testing::dji_takeoff;
using testing::dji_turn;
using testing::dji_waypoint;
using testing::element;
using testing::in_kml;

DjiMission read(const std::string& text) {
  return read_dji_waylines(parse_xml(text, "m.kmz"), "m.kmz");
}

// The message without its place.
std::string refusal(const std::string& text) {
  const std::string said = support::refusal_of([&] { read(text); });
  return said.substr(std::min(said.find(": "), said.size()));
}

std::string refusal_of_config(const std::string& config) {
  return refusal(in_kml(config + dji_folder(dji_leg())));
}

std::string refusal_of_folder(const std::string& folder) {
  return refusal(in_kml(dji_config() + folder));
}

std::string refusal_of_waypoint(const std::string& more) {
  return refusal_of_folder(dji_folder(dji_waypoint(0, "8,47", "30", more)));
}

// DJI documents no less, so nobody knows what an aircraft makes of it.
TEST(DjiWaylines, FlyToTheirBeginningAtOneMetreASecondAtLeast) {
  std::string config = dji_config();
  config.replace(config.find(">9<"), 3, ">0.3<");
  EXPECT_EQ(read(in_kml(config + dji_folder(dji_leg()))).transit_speed, 1);
}

TEST(DjiWaylines, SayAMission) {
  const DjiMission m =
      read(in_kml(dji_config(dji_takeoff() + element("globalRTHHeight", "60") +
                                 element("executeRCLostAction", "hover"),
                             "goHome", "pointToPoint", "67") +
                      dji_folder(dji_waypoint(0, "8.5,47.25", "30.5",
                                              dji_turn() + element("waypointSpeed", "6")) +
                                 dji_waypoint(1, "-8,-47", "-2")) +
                      dji_folder(dji_leg(), "WGS84", "", "3"),
                  "1.0.2"));
  EXPECT_EQ(m.version, "1.0.2");
  EXPECT_EQ(m.aircraft, (DjiAircraft{67, 0}));
  EXPECT_EQ(m.approach, DjiApproach::point_to_point);
  EXPECT_EQ(m.finish, DjiFinish::go_home);
  EXPECT_EQ(m.security_height, 20);
  EXPECT_EQ(m.transit_speed, 9);
  EXPECT_EQ(m.return_height, 60);
  EXPECT_EQ(m.takeoff, (geom::GeodeticPlace{47, 8, 400}));
  EXPECT_EQ(m.without_link, "goContinue");
  ASSERT_EQ(m.waylines.size(), 2u);
  const auto& points = m.waylines[0].waypoints;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].latitude, 47.25);
  EXPECT_EQ(points[0].longitude, 8.5);
  EXPECT_EQ(points[0].height, 30.5);
  EXPECT_EQ(points[0].speed, 6);
  EXPECT_EQ(points[1].latitude, -47);
  EXPECT_EQ(points[1].speed, 4) << "the wayline's";
  EXPECT_EQ(m.waylines[0].heights, DjiHeights::above_takeoff);
  EXPECT_EQ(m.waylines[1].heights, DjiHeights::ellipsoid);
  EXPECT_EQ(m.waylines[1].template_id, 3);
}

TEST(DjiWaylines, FinishInFourWays) {
  const auto finish = [](const char* word) {
    return read(in_kml(dji_config("", word) + dji_folder(dji_leg()))).finish;
  };
  EXPECT_EQ(finish("goHome"), DjiFinish::go_home);
  EXPECT_EQ(finish("noAction"), DjiFinish::hover);
  EXPECT_EQ(finish("autoLand"), DjiFinish::land);
  EXPECT_EQ(finish("gotoFirstWaypoint"), DjiFinish::first_waypoint);
}

TEST(DjiWaylines, CountActionsAndAddTheirRests) {
  const auto action = [](const std::string& function, const std::string& param) {
    return element("action", element("actionId", "0") + element("actionActuatorFunc", function) +
                                 element("actionActuatorFuncParam", param));
  };
  const std::string group =
      element("actionGroup",
              element("actionGroupId", "0") + element("actionGroupStartIndex", "0") +
                  element("actionGroupEndIndex", "0") + element("actionGroupMode", "sequence") +
                  element("actionTrigger", element("actionTriggerType", "reachPoint")) +
                  action("hover", element("hoverTime", "2.5")) +
                  action("takePhoto", element("fileSuffix", "a")) +
                  action("rotateYaw", element("aircraftHeading", "90")));
  const DjiMission m = read(
      in_kml(dji_config() + dji_folder(dji_waypoint(0, "8,47", "30", dji_turn() + group + group))));
  EXPECT_EQ(m.actions, 6u);
  EXPECT_EQ(m.waylines[0].waypoints[0].hover, 5);
  EXPECT_EQ(refusal_of_waypoint(dji_turn() + element("actionGroup", action("dropPayload", ""))),
            ": expected an action that is known to move the aircraft nowhere (of cameras, gimbals, "
            "yaw, rest), found \"dropPayload\"");
  EXPECT_EQ(refusal_of_waypoint(dji_turn() + element("actionGroup", action("hover", ""))),
            ": expected <wpml:hoverTime> in <wpml:actionActuatorFuncParam>, found none");
}

TEST(DjiWaylines, OtherVersionsAndNamespacesAreRefused) {
  const std::string inside = dji_config() + dji_folder(dji_leg());
  for (const char* version : {"1.0.0", "1.0.2", "1.0.3", "1.0.4", "1.0.5"}) {
    EXPECT_EQ(refusal(in_kml(inside, version)), "") << version;
  }
  EXPECT_EQ(refusal(in_kml(inside, "1.0.7")),
            ": expected WPML of version 1.0.0 or 1.0.2 to 1.0.6, found 1.0.7");
  const auto root = [&](const std::string& attributes) {
    return refusal("<kml " + attributes + "><Document>" + inside + "</Document></kml>");
  };
  const std::string kml = "xmlns=\"http://www.opengis.net/kml/2.2\"";
  const std::string wpml = "xmlns:wpml=\"http://www.dji.com/wpmz/1.0.6\"";
  EXPECT_EQ(root(kml + " " + wpml), "");
  EXPECT_EQ(root(kml + " xmlns:wpml=\"http://www.uav.com/wpmz/1.0.2\""),
            ": expected the namespace http://www.dji.com/wpmz/1.0.0 or 1.0.2 to 1.0.6, found "
            "\"http://www.uav.com/wpmz/1.0.2\"");
  EXPECT_EQ(root(wpml), ": expected xmlns in <kml>, found none");
  EXPECT_EQ(root(kml + " " + wpml + " " + wpml),
            ": expected each attribute of a tag once, found one twice");
  EXPECT_EQ(root("xmlns=\"x\" " + wpml),
            ": expected the namespace http://www.opengis.net/kml/2.2, found \"x\"");
  EXPECT_EQ(refusal_of_folder("<Folder xmlns:wpml=\"x\"/>"),
            ": expected namespaces in <kml> alone, found one");
  EXPECT_EQ(refusal("<gpx/>"), ": expected WPML (<kml>), found <gpx>");
}

TEST(DjiWaylines, WhatMovesTheAircraftInUnknownWaysIsRefused) {
  const std::string off = "> must be 0, found 1: the aircraft would leave its way as it sees fit";
  EXPECT_EQ(
      refusal_of_folder(dji_folder(dji_leg(), "WGS84", element("realTimeFollowSurfaceByFov", "1"))),
      ": <wpml:realTimeFollowSurfaceByFov" + off);
  EXPECT_EQ(refusal_of_config(
                dji_config(element("autoRerouteInfo", element("missionAutoRerouteMode", "1")))),
            ": <wpml:missionAutoRerouteMode" + off);
  EXPECT_EQ(refusal_of_config(dji_config(element("waylineAvoidLimitAreaMode", "1"))),
            ": <wpml:waylineAvoidLimitAreaMode" + off);
  EXPECT_EQ(refusal_of_config(dji_config(element("climbFirst", "1"))),
            ": <wpml:climbFirst> in <wpml:missionConfig> is not known here, and might move the "
            "aircraft");
  EXPECT_EQ(refusal_of_waypoint(dji_turn() + element("waypointWorkType", "2")),
            ": <wpml:waypointWorkType> must be 0, found \"2\"");
}

TEST(DjiWaylines, MayFollowTheSurface) {
  const std::string by_view = element("realTimeFollowSurfaceByFov", "1");
  for (const std::string& more : {std::string(), by_view}) {
    const std::string folder = dji_folder(dji_leg(), "realTimeFollowSurface", more);
    const DjiMission m = read(in_kml(dji_config() + folder));
    EXPECT_EQ(m.waylines[0].heights, DjiHeights::above_surface);
  }
  EXPECT_EQ(refusal_of_folder(dji_folder(dji_leg(), "EGM96")),
            ": <wpml:executeHeightMode> must be WGS84 or relativeToStartPoint or "
            "realTimeFollowSurface, found \"EGM96\"");
}

TEST(DjiWaylines, SayTurns) {
  const auto turn = [](const std::string& mode, const std::string& damping,
                       const std::string& straight) {
    const std::string more = dji_turn(mode, damping) + element("useStraightLine", straight);
    const std::string folder = dji_folder(dji_waypoint(0, "8,47", "30", more));
    return read(in_kml(dji_config() + folder)).waylines[0].waypoints[0];
  };
  const DjiWaypoint early = turn("coordinateTurn", "5", "0");
  EXPECT_EQ(early.turn, DjiTurn::early);
  EXPECT_EQ(early.damping, 5);
  const DjiWaypoint through = turn("toPointAndPassWithContinuityCurvature", "2.5", "1");
  EXPECT_EQ(through.turn, DjiTurn::through);
  EXPECT_EQ(through.damping, 2.5);
  EXPECT_EQ(turn("toPointAndStopWithDiscontinuityCurvature", "5", "0").damping, 0) << "it stops";
}

TEST(DjiWaylines, CurvedLegsAreRefused) {
  const std::string known =
      ": expected straight legs with a stop or a turn at each waypoint "
      "(toPointAndStopWithDiscontinuityCurvature, coordinateTurn, or "
      "toPointAndPassWithContinuityCurvature with <wpml:useStraightLine> 1), found ";
  const std::string pass = "toPointAndPassWithContinuityCurvature";
  EXPECT_EQ(refusal_of_waypoint(dji_turn(pass, "5")), known + '"' + pass + '"');
  EXPECT_EQ(refusal_of_waypoint(dji_turn(pass, "5") + element("useStraightLine", "0")),
            known + '"' + pass + '"');
  const std::string stop = "toPointAndStopWithContinuityCurvature";
  EXPECT_EQ(refusal_of_waypoint(dji_turn(stop, "5") + element("useStraightLine", "1")),
            known + '"' + stop + '"');
  EXPECT_EQ(refusal_of_waypoint(dji_turn("coordinateTurn", "0")),
            ": <wpml:waypointTurnDampingDist> must be > 0 m where the aircraft does not stop, "
            "found 0");
  EXPECT_EQ(refusal_of_waypoint(
                element("waypointTurnParam", element("waypointTurnMode", "coordinateTurn"))),
            ": expected <wpml:waypointTurnDampingDist> in <wpml:waypointTurnParam>, found none");
}

TEST(DjiWaylines, BadValuesAreRefused) {
  EXPECT_EQ(refusal_of_folder(dji_folder(dji_waypoint(1, "8,47", "30"))),
            ": <wpml:index> must be 0, the next, found 1");
  EXPECT_EQ(refusal_of_folder(dji_folder(dji_waypoint(0, "8,97", "30"))),
            ": <coordinates> must be longitude,latitude within 180 and 90 degrees, found \"8,97\"");
  for (const char* place : {"", ",", "8", "8,47,3", "8 47", "nan,47", "8,47,"}) {
    EXPECT_NE(refusal_of_folder(dji_folder(dji_waypoint(0, place, "30"))), "") << place;
  }
  EXPECT_EQ(refusal_of_folder(dji_folder(dji_waypoint(0, "8,47", "high"))),
            ": <wpml:executeHeight> must be a number from -100000 to 100000, found \"high\"");
  EXPECT_EQ(refusal_of_waypoint(""),
            ": expected <wpml:waypointTurnParam> in <Placemark>, found "
            "none");
  EXPECT_EQ(refusal_of_waypoint(dji_turn() + element("waypointSpeed", "0")),
            ": <wpml:waypointSpeed> must be > 0 m/s, found 0");
  EXPECT_EQ(refusal_of_config(""), ": expected <wpml:missionConfig> in <Document>, found none");
  EXPECT_EQ(refusal_of_config(dji_config("", "dance")),
            ": <wpml:finishAction> must be goHome or noAction or autoLand or gotoFirstWaypoint, "
            "found \"dance\"");
  EXPECT_EQ(refusal_of_folder(""), ": expected at least one <Folder> of waypoints, found none");
  EXPECT_EQ(refusal_of_folder(dji_folder("")), ": expected waypoints in <Folder>, found none");
  for (const char* place : {"47,8", "47,8,high", "97,8,0", "47,188,0", "47,8,0,0", ""}) {
    EXPECT_EQ(refusal_of_config(dji_config(dji_takeoff(place))),
              ": <wpml:takeOffRefPoint> must be latitude,longitude,height, found \"" +
                  std::string(place) + "\"");
  }
}

TEST(DjiWaylines, FlyInTheOrderOfTheirIds) {
  const auto folders = [](const char* first, const char* second) {
    return dji_folder(dji_leg(), "relativeToStartPoint", "", first) +
           dji_folder(dji_leg(), "relativeToStartPoint", "", second);
  };
  EXPECT_EQ(refusal_of_folder(folders("0", "4")), "");
  EXPECT_EQ(refusal_of_folder(folders("1", "0")),
            ": <wpml:waylineId> must be above 1, the one before, found 0");
  EXPECT_EQ(refusal_of_folder(folders("2", "2")),
            ": <wpml:waylineId> must be above 2, the one before, found 2");
}

TEST(DjiWaylines, ZerosAreNoTakeOff) {
  const auto takeoff = [](const char* place) {
    return read(in_kml(dji_config(dji_takeoff(place)) + dji_folder(dji_leg()))).takeoff;
  };
  EXPECT_FALSE(takeoff("0.000000,0.000000,0.000000"));
  EXPECT_TRUE(takeoff("0.000000,0.000000,1"));
}

TEST(DjiWaylines, ALostLinkIsNamed) {
  std::string config = dji_config(element("executeRCLostAction", "goBack"));
  config.replace(config.find("goContinue"), 10, "executeLostAction");
  EXPECT_EQ(read(in_kml(config + dji_folder(dji_leg()))).without_link, "goBack");
  std::string unsaid = dji_config();
  unsaid.replace(unsaid.find("goContinue"), 10, "executeLostAction");
  EXPECT_EQ(refusal_of_config(unsaid),
            ": expected <wpml:executeRCLostAction> in <wpml:missionConfig>, found none");
}

}  // namespace
}  // namespace traj
