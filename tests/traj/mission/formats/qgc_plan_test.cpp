#include "traj/mission/formats/qgc_plan.h"

#include <gtest/gtest.h>

#include <sstream>

#include "support/reading.h"
#include "traj/mission/mavlink/examples.h"
#include "traj/mission/mavlink/mission.h"

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
  return support::refusal_of([&] { read_qgc_plan(support::Text(text), "m.plan"); });
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
  EXPECT_EQ(plan_refusal("\"AltitudeMode\": 1", "\"AltitudeMode\": 3"),
            "m.plan: mission.items[0].AltitudeMode must be 1, 2, 3 or 4 (above home, sea level, by "
            "way of "
            "the terrain, above it) as its frame 3 says, found 3");
  EXPECT_EQ(plan_refusal("\"params\": [\n     0.0,", "\"params\": ["),
            "m.plan: mission.items[0].params must be a list of 7, found "
            "[0.0,0.0,null,37.7964487,-122.4010293,18.0]");
  EXPECT_EQ(plan_refusal("\"command\": 22", "\"command\": \"takeoff\""),
            "m.plan: mission.items[0].command must be a finite number, found \"takeoff\"");
  EXPECT_EQ(plan_refusal("{", "["),
            "m.plan:2: column 12: this is not JSON: expected , or ], found :");
}

std::string plan(const std::string& items, const std::string& rest = "") {
  return R"({"fileType":"Plan","version":1,"mission":{"version":2,"plannedHomePosition":[47,8,410],"items":[)" +
         items + "]}" + rest + "}";
}

std::string item(const std::string& keys, int number = 1) {
  return R"({"type":"SimpleItem","command":16,"doJumpId":)" + std::to_string(number) +
         R"(,"params":[0,0,0,null,47,8,30],)" + keys + "}";
}

Mission read(const std::string& text) { return read_qgc_plan(support::Text(text), "m.plan"); }

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

TEST(QgcPlan, NotesHeightsThatDependOnTerrain) {
  EXPECT_TRUE(read(plan(item(R"("frame":0,"AltitudeMode":2)"))).notes.empty());
  const Mission mission = read(plan(item(R"("frame":0,"AltitudeMode":3)")));
  ASSERT_EQ(mission.notes.size(), 1u);
  EXPECT_TRUE(mission.notes[0].starts_with("QGroundControl worked out 1 height from its terrain"))
      << mission.notes[0];
}

TEST(QgcPlan, ReadsWhetherAnItemGoesOn) {
  const auto goes_on = [](const std::string& value) {
    return read(plan(item(R"("frame":3,"autoContinue":)" + value))).items[0].goes_on;
  };
  EXPECT_TRUE(goes_on("true"));
  EXPECT_TRUE(goes_on("1"));
  EXPECT_FALSE(goes_on("false"));
  EXPECT_FALSE(goes_on("0"));
  EXPECT_TRUE(read(plan(item(R"("frame":3)"))).items[0].goes_on);
  EXPECT_EQ(refusal(plan(item(R"("frame":3,"autoContinue":"no")"))),
            "m.plan: mission.items[0].autoContinue must be true or false, found \"no\"");
}

TEST(QgcPlan, HoldsTheHeightsThatItSaysTwiceAgainstEachOther) {
  EXPECT_EQ(
      refusal(plan(item(R"("frame":0,"AltitudeMode":3,"Altitude":12,"AMSLAltAboveTerrain":30)"))),
      "");
  EXPECT_EQ(
      refusal(plan(item(R"("frame":10,"AltitudeMode":4,"Altitude":30,"AMSLAltAboveTerrain":99)"))),
      "");
  EXPECT_EQ(
      refusal(plan(item(R"("frame":0,"AltitudeMode":3,"AMSLAltAboveTerrain":31)"))),
      "m.plan: mission.items[0].AMSLAltAboveTerrain must be the height in params, 30, found 31");
  EXPECT_EQ(refusal(plan(item(R"("frame":3,"AltitudeMode":1,"Altitude":31)"))),
            "m.plan: mission.items[0].Altitude must be the height in params, 30, found 31");
  EXPECT_NE(refusal(plan(item(R"("frame":10,"AltitudeMode":1)"))), "");
}

TEST(QgcPlan, ReadsFencesAndRallyPoints) {
  const Mission mission = read(plan(item(R"("frame":3)"), R"(,"geoFence":{"version":2,
    "circles":[{"circle":{"center":[47,8],"radius":90},"inclusion":true,"version":1}],
    "polygons":[{"polygon":[[47,8],[47.1,8],[47,8.1]],"inclusion":false,"version":1}]},
    "rallyPoints":{"version":2,"points":[[47.01,8.02,50]]})"));
  ASSERT_EQ(mission.fences.size(), 2u);
  EXPECT_EQ(mission.fences[0].radius, 90);
  EXPECT_TRUE(mission.fences[0].inclusion);
  EXPECT_EQ(mission.fences[1].ring.size(), 3u);
  EXPECT_FALSE(mission.fences[1].inclusion);
  ASSERT_EQ(mission.rally.size(), 1u);
  EXPECT_EQ(mission.rally[0].height, 50);
  const auto fenced = [](const std::string& fence) {
    return refusal(plan(item(R"("frame":3)"), R"(,"geoFence":)" + fence));
  };
  EXPECT_EQ(
      fenced(
          R"({"version":2,"circles":[{"circle":{"center":[47],"radius":90},"inclusion":true}]})"),
      "m.plan: geoFence.circles[0].circle.center must be a list of 2 numbers, found [47]");
  EXPECT_EQ(fenced(R"({"version":2,"circles":[{"circle":{"center":[47,8],"radius":90}}]})"),
            "m.plan: expected the key geoFence.circles[0].inclusion, found none");
  EXPECT_EQ(fenced(R"({"version":2,"polygons":[{"polygon":[],"inclusion":true}]})"),
            "m.plan: geoFence.polygons[0].polygon must have corners, found none");
  EXPECT_EQ(fenced(R"({"version":2,"polygons":7})"),
            "m.plan: geoFence.polygons must be a list, found 7");
}

TEST(QgcPlan, RefusesWhatMayBeAFenceOfAnotherKind) {
  const std::string one = item(R"("frame":3)");
  EXPECT_EQ(refusal(plan(one, R"(,"geoFence":{"version":1,"polygon":[[47,8],[47.1,8],[47,8.1]]})")),
            "m.plan: expected no other keys in geoFence than breachReturn, circles, polygons, "
            "version, found \"polygon\"");
  EXPECT_EQ(refusal(plan(one, R"(,"geoFence":{"version":1,"circles":[]})")),
            "m.plan: geoFence.version must be 2, found 1");
  EXPECT_EQ(refusal(plan(one, R"(,"geofence":{})")),
            "m.plan: expected no other keys in plan than fileType, geoFence, groundStation, "
            "mission, rallyPoints, version, found \"geofence\"");
  EXPECT_EQ(refusal(plan(one, R"(,"geoFence":{})")), "");
}

TEST(QgcPlan, TakesTheItemsThatASurveyHolds) {
  const std::string survey =
      R"({"type":"ComplexItem","complexItemType":"survey","TransectStyleComplexItem":{"Items":[)" +
      item(R"("frame":3)", 2) + "," + item(R"("frame":3)", 3) + "]}}";
  const Mission mission =
      read(plan(item(R"("frame":3)") + "," + survey + "," + item(R"("frame":3)", 4)));
  ASSERT_EQ(mission.items.size(), 4u);
  EXPECT_EQ(mission.items[2].number, 3u);
  EXPECT_EQ(refusal(plan(R"({"type":"ComplexItem","TransectStyleComplexItem":{"Items":[]}})")),
            "m.plan: mission.items[0].TransectStyleComplexItem.Items must hold the items that "
            "QGroundControl makes of it, found none: open the plan there and save it again");
  EXPECT_EQ(refusal(plan(R"({"type":"ComplexItem","complexItemType":"StructureScan"})")),
            "m.plan: mission.items[0].type must be \"SimpleItem\", found \"ComplexItem\"");
}

TEST(QgcPlan, ComesBackItemByItem) {
  const Mission mission = every_item();
  std::stringstream file;
  write_qgc_plan(file, mission, "test");
  const Mission back = read_qgc_plan(file, "m.plan");
  expect_same(back, mission);
}

TEST(QgcPlan, PassesOverWordsAndNumbersThatItDoesNotKnow) {
  const std::string one = item(R"("frame":3)");
  const Mission mission = read(plan(one, R"(,"UUID":"ab-12","saved":17)"));
  EXPECT_EQ(mission.items.size(), 1u);
  EXPECT_EQ(mission.notes, (std::vector<std::string>{
                               "its member \"UUID\" is not known here, and is passed over",
                               "its member \"saved\" is not known here, and is passed over"}));
  EXPECT_EQ(refusal(plan(one, R"(,"zones":[])")),
            "m.plan: expected no other keys in plan than fileType, geoFence, groundStation, "
            "mission, rallyPoints, version, found \"zones\"");
}

TEST(QgcPlan, FencesAndRallyPointsComeBack) {
  Mission mission = make_mission(kPoints, kFrame, mission_options());
  mission.fences.push_back({true, {{47, 8, 0}, {47.001, 8, 0}, {47.001, 8.0000001, 0}}, {}, 0});
  mission.fences.push_back({false, {}, {47.0005, 8.0001, 0}, 12.5});
  mission.rally.push_back({47.0002, 8.0003, 30.125});
  std::stringstream file;
  write_qgc_plan(file, mission, "test");
  const Mission read = read_qgc_plan(file, "m.plan");
  const std::vector<GeodeticFence>& back = read.fences;
  ASSERT_EQ(back.size(), 2u);
  EXPECT_FALSE(back[0].inclusion) << "circles come first";
  EXPECT_EQ(back[0].centre, mission.fences[1].centre);
  EXPECT_EQ(back[0].radius, 12.5);
  EXPECT_TRUE(back[1].inclusion);
  EXPECT_EQ(back[1].ring, mission.fences[0].ring);
  EXPECT_EQ(read.rally, mission.rally);
}

}  // namespace
}  // namespace traj
