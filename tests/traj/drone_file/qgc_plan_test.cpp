#include "traj/drone_file/qgc_plan.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "traj/drone_file/examples.h"
#include "traj/drone_file/mission.h"

namespace traj {
namespace {

using testing::every_item;
using testing::expect_same;
using testing::kFrame;
using testing::kPoints;
using testing::mission_options;

std::string plan_refusal(const std::string& from, const std::string& to) {
  std::stringstream made;
  write_qgc_plan(made, make_mission(kPoints, kFrame, mission_options()), "test");
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
  const Mission mission = every_item();
  std::stringstream file;
  write_qgc_plan(file, mission, "test");
  const Mission back = read_qgc_plan(file, "m.plan");
  expect_same(back, mission);
}

}  // namespace
}  // namespace traj
