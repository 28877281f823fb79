#include "traj/drone_file/qgc_plan.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "traj/drone_file/mission.h"

namespace traj {
namespace {

const MissionFrame kFrame{{37.79248, -122.39745, 12.5}, -32};
const std::vector<Vec3> kPoints = {{-315.25, 440.5, 20}, {10, -3, 31.25}, {250, 700, 8}};

MissionOptions options() {
  MissionOptions o;
  o.home = 2;
  o.landing_on = 6.5;
  o.speed = 4.5;
  return o;
}

std::string plan_refusal(const std::string& from, const std::string& to) {
  std::stringstream made;
  write_qgc_plan(made, make_mission(kPoints, kFrame, options()), "test");
  std::string text = made.str();
  const std::size_t at = text.find(from);
  if (at == text.npos) return "not there";
  text.replace(at, from.size(), to);
  std::istringstream in(text);
  try {
    read_qgc_plan(in, "m.plan");
  } catch (const geom::InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(QgcPlan, BadFilesAreRefused) {
  EXPECT_EQ(plan_refusal("\"Plan\"", "\"Fence\""),
            "m.plan: plan.fileType must be \"Plan\", found \"Fence\"");
  EXPECT_EQ(plan_refusal("\"items\"", "\"waypoints\""),
            "m.plan: expected the key mission.items, found none");
  EXPECT_EQ(plan_refusal("\"vehicleType\": 2,\n  \"version\": 2", "\"version\": 1"),
            "m.plan: mission.version must be 2, found 1");
  EXPECT_EQ(plan_refusal("\"SimpleItem\"", "\"ComplexItem\""),
            "m.plan: mission.items[0].type must be \"SimpleItem\", found \"ComplexItem\"");
  EXPECT_EQ(
      plan_refusal("\"AltitudeMode\": 1", "\"AltitudeMode\": 3"),
      "m.plan: mission.items[0].AltitudeMode must be 1 or 2 (above home or sea level) as its frame "
      "3 says, found 3");
  EXPECT_EQ(plan_refusal("\"params\": [\n     0.0,", "\"params\": ["),
            "m.plan: mission.items[0].params must be a list of 7, found "
            "[0.0,0.0,null,37.7964487,-122.4010293,18.0]");
  EXPECT_EQ(plan_refusal("\"command\": 22", "\"command\": \"takeoff\""),
            "m.plan: mission.items[0].command must be a finite number, found \"takeoff\"");
  EXPECT_EQ(plan_refusal("{", "["),
            "m.plan:2: column 12: this is not JSON: expected , or ], found :");
}

TEST(QgcPlan, ComesBackItemByItem) {
  Mission mission;
  mission.home = geom::GeodeticPlace{47, 8, 410.5};
  mission.items = {{kGlobalRelative, kTakeoff, {0, 0, 0, 0}, 47, 8, 15},
                   {kMissionFrame, kSpeed, {1, 4.5, -1, 0}, 0, 0, 0},
                   {kGlobalRelative, kWaypoint, {2, 0.25, 0, 0}, 47.0012345, 8.0054321, 20.125},
                   {kGlobalRelative, kLand, {0, 0, 0, 0}, 47.0012345, 8.0054321, 0}};
  std::stringstream file;
  write_qgc_plan(file, mission, "test");
  const Mission back = read_qgc_plan(file, "m.plan");
  ASSERT_TRUE(back.home);
  EXPECT_EQ(*back.home, *mission.home);
  ASSERT_EQ(back.items.size(), mission.items.size());
  for (std::size_t i = 0; i < mission.items.size(); ++i) {
    const MissionItem& a = back.items[i];
    const MissionItem& b = mission.items[i];
    EXPECT_EQ(a.frame, b.frame) << i;
    EXPECT_EQ(a.command, b.command) << i;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a.param[k], b.param[k]) << i;
    EXPECT_EQ(a.latitude, b.latitude) << i;
    EXPECT_EQ(a.longitude, b.longitude) << i;
    EXPECT_EQ(a.altitude, b.altitude) << i;
  }
}

}  // namespace
}  // namespace traj
