#include "mission/dji/dji_template.h"

#include <gtest/gtest.h>

#include "mission/dji/dji_waylines.h"
#include "support/reading.h"
#include "traj/mission/dji/dji_examples.h"

namespace traj {
namespace {

using testing::dji_config;
using testing::dji_folder;
using testing::dji_leg;
using testing::dji_takeoff;
using testing::dji_template_folder;
using testing::dji_template_waypoint;
using testing::dji_turn;
using testing::element;
using testing::in_kml;

DjiMission mission(const std::string& heights = "relativeToStartPoint",
                   const std::string& more = "") {
  const std::string text = in_kml(dji_config(more) + dji_folder(dji_leg(), heights));
  return read_dji_waylines(parse_xml(text, "m"), "m");
}

std::string refusal(const std::string& inside, DjiMission made = mission()) {
  const std::string said = support::refusal_of(
      [&] { hold_against_template(parse_xml(in_kml(inside), "t"), "t", made); });
  return said.substr(std::min(said.find(": "), said.size()));
}

const std::string kElsewhere =
    " than in waylines.wpml, which the aircraft flies: an app that opens the mission may replace "
    "it; save it in that app again";

std::string waypoints(const std::string& second = "8.001,47", const std::string& height = "35") {
  return dji_template_waypoint(0, "8,47", element("useGlobalHeight", "1")) +
         dji_template_waypoint(1, second,
                               element("useGlobalHeight", "0") + element("height", height));
}

TEST(DjiTemplate, OfTheSameFlightIsTaken) {
  EXPECT_EQ(refusal(dji_config() + dji_template_folder(waypoints())), "");
  EXPECT_EQ(refusal(""), "");
  EXPECT_EQ(refusal(element("author", "x") + dji_config() +
                    dji_template_folder(waypoints(), element("surelyUnknown", "x"))),
            "");
}

TEST(DjiTemplate, OfAnotherFlightIsRefused) {
  EXPECT_EQ(refusal(dji_template_folder(waypoints("8.001001,47"))),
            ": this waypoint is elsewhere" + kElsewhere);
  EXPECT_EQ(refusal(dji_template_folder(waypoints("8.001,47", "35.5"))),
            ": <wpml:height> is another" + kElsewhere);
  EXPECT_EQ(refusal(dji_template_folder(dji_template_waypoint(0, "8,47", ""))),
            ": this template has other waypoints" + kElsewhere);
  EXPECT_EQ(refusal(dji_config("", "goHome")), ": <wpml:finishAction> is another" + kElsewhere);
  EXPECT_EQ(refusal(dji_config("", "noAction", "pointToPoint")),
            ": <wpml:flyToWaylineMode> is another" + kElsewhere);
}

TEST(DjiTemplate, OfOtherTurnsIsRefused) {
  const std::string own = element("useGlobalTurnParam", "0") + dji_turn("coordinateTurn", "5") +
                          element("height", "30");
  EXPECT_EQ(
      refusal(dji_template_folder(dji_template_waypoint(0, "8,47", own) +
                                  dji_template_waypoint(1, "8.001,47", element("height", "35")))),
      ": <wpml:waypointTurnMode> is another" + kElsewhere);
  std::string folder = dji_template_folder(waypoints());
  const std::string stop = "toPointAndStopWithDiscontinuityCurvature";
  folder.replace(folder.find(stop), stop.size(), "coordinateTurn");
  EXPECT_EQ(refusal(folder), ": <wpml:globalWaypointTurnMode> is another" + kElsewhere);
}

TEST(DjiTemplate, OfTheSameTurnsIsTaken) {
  DjiMission made = mission();
  made.waylines[0].waypoints[1].turn = DjiTurn::early;
  made.waylines[0].waypoints[1].damping = 5;
  const auto folder = [](const std::string& damping) {
    const std::string own = element("useGlobalTurnParam", "0") +
                            dji_turn("coordinateTurn", damping) + element("height", "35");
    return dji_template_folder(dji_template_waypoint(0, "8,47", element("height", "30")) +
                               dji_template_waypoint(1, "8.001,47", own));
  };
  EXPECT_EQ(refusal(folder("5"), made), "");
  EXPECT_EQ(refusal(folder("6"), made), ": <wpml:waypointTurnDampingDist> is another" + kElsewhere);
}

TEST(DjiTemplate, OtherHeightsAreComparedWhereTheyCountAlike) {
  const auto folder = [](const std::string& height) {
    const std::string both = element("ellipsoidHeight", height) + element("height", "2");
    return dji_template_folder(dji_template_waypoint(0, "8,47", element("ellipsoidHeight", "30")) +
                                   dji_template_waypoint(1, "8.001,47", both),
                               "", "EGM96");
  };
  EXPECT_EQ(refusal(folder("35"), mission("WGS84")), "");
  EXPECT_EQ(refusal(folder("36"), mission("WGS84")),
            ": <wpml:ellipsoidHeight> is another" + kElsewhere);
  EXPECT_EQ(refusal(folder("36")), "") << "one above the sea, one above the take-off";
}

TEST(DjiTemplate, FollowsTheSurfaceWhereTheWaylinesDo) {
  const auto of = [](const char* heights) { return dji_template_folder(waypoints(), "", heights); };
  const std::string other = ": <wpml:heightMode> is another" + kElsewhere;
  const DjiMission follows = mission("realTimeFollowSurface");
  EXPECT_EQ(refusal(of("realTimeFollowSurface"), follows), "");
  EXPECT_EQ(refusal(of("aboveGroundLevel"), follows), "");
  EXPECT_EQ(refusal(of("relativeToStartPoint"), follows), other);
  EXPECT_EQ(refusal(of("EGM96"), follows), other);
  EXPECT_EQ(refusal(of("realTimeFollowSurface")), other);
  EXPECT_EQ(refusal(of("aboveGroundLevel")), "");
  EXPECT_NE(refusal(of("foo")), "");
}

TEST(DjiTemplate, SaysTheTakeOffWhereTheWaylinesDoNot) {
  DjiMission made = mission();
  hold_against_template(parse_xml(in_kml(dji_config(dji_takeoff())), "t"), "t", made);
  EXPECT_EQ(made.takeoff, (geom::GeodeticPlace{47, 8, 400}));
  EXPECT_EQ(
      refusal(dji_config(dji_takeoff("47,8,401")), mission("relativeToStartPoint", dji_takeoff())),
      ": <wpml:takeOffRefPoint> is another" + kElsewhere);
}

TEST(DjiTemplate, CalibrationFlightsAreRefused) {
  EXPECT_EQ(refusal(dji_template_folder(waypoints(), element("caliFlightEnable", "0"))), "");
  EXPECT_EQ(refusal(dji_template_folder(waypoints(), element("caliFlightEnable", "1"))),
            ": <wpml:caliFlightEnable> must be 0, found 1: the aircraft would fly to and fro to "
            "calibrate its lidar");
}

TEST(DjiTemplate, OfAnotherVersionIsRefused) {
  DjiMission made = mission();
  EXPECT_NE(support::refusal_of(
                [&] { hold_against_template(parse_xml(in_kml("", "9"), "t"), "t", made); }),
            "");
}

}  // namespace
}  // namespace traj
