#include "traj/export/mission.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/error.h"
#include "support/refusal.h"
#include "traj/export/geo_line.h"
#include "traj/export/gltf_line.h"
#include "traj/export/qgc_plan.h"
#include "traj/export/wpl.h"

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

void expect_flown(const FlownMission& flown) {
  ASSERT_EQ(flown.path.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    EXPECT_LT((flown.path[i] - kPoints[i]).head<2>().norm(), 0.008) << "1e-7 degrees";
    EXPECT_NEAR(flown.path[i].z(), kPoints[i].z(), 0.0006);
  }
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 1, 1}));
  EXPECT_NEAR(*flown.ends.takeoff_from, 2, 0.0006);
  EXPECT_NEAR(*flown.ends.landing_on, 6.5, 0.0006);
  EXPECT_EQ(flown.speed, 4.5);
  EXPECT_FALSE(flown.returns);
}

TEST(Mission, ComesBackFromBothFilesAsItWasMade) {
  const Mission mission = make_mission(kPoints, kFrame, options());
  expect_flown(flown_mission(mission, kFrame, {}, "mission"));
  std::stringstream wpl;
  write_wpl(wpl, mission);
  expect_flown(flown_mission(read_wpl(wpl, "m.wpl"), kFrame, {}, "m.wpl"));
  std::stringstream plan;
  write_qgc_plan(plan, mission, "test");
  expect_flown(flown_mission(read_qgc_plan(plan, "m.plan"), kFrame, {}, "m.plan"));
}

TEST(Mission, AHomeThatIsGivenCountsBeforeTheFiles) {
  const Mission mission = make_mission(kPoints, kFrame, options());
  const FlownMission flown = flown_mission(mission, kFrame, 102.0, "mission");
  EXPECT_NEAR(flown.path[1].z(), kPoints[1].z() + 100, 0.0006);
}

FlownMission fly(const std::string& items) {
  std::istringstream in("QGC WPL 110\n" + items);
  return flown_mission(read_wpl(in, "m.wpl"), {{47, 8, 400}, 0}, {}, "m.wpl");
}

std::string refusal(const std::string& items) {
  return support::refusal_of([&] { fly(items); });
}

constexpr const char* kHome = "0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n";

TEST(Wpl, ReadsTakeOffsWithoutPlaceLoiteringDelaysAndReturns) {
  const FlownMission flown = fly(std::string(kHome) +
                                 "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n"
                                 "2\t0\t3\t19\t7\t0\t0\t0\t47.001\t8\t20\t1\n"
                                 "3\t0\t2\t93\t2\t0\t0\t0\t0\t0\t0\t1\n"
                                 "4\t0\t0\t16\t0\t0\t0\t0\t47.001\t8.001\t440\t1\n"
                                 "5\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n"
                                 "6\t0\t3\t16\t0\t0\t0\t0\t47\t8\t5\t1\n");
  ASSERT_EQ(flown.path.size(), 3u) << "nothing after the return";
  EXPECT_LT((flown.path[0] - Vec3(0, 0, 25)).norm(), 1e-6);
  EXPECT_NEAR(flown.path[1].y(), 111.17, 0.05);
  EXPECT_EQ(flown.path[1].z(), 30);
  EXPECT_EQ(flown.path[2].z(), 40) << "above the sea";
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 9, 0}));
  EXPECT_TRUE(flown.returns);
}

TEST(Wpl, BadFilesAreRefused) {
  const std::string home = kHome;
  EXPECT_EQ(refusal(home), "m.wpl: expected \"QGC WPL 110\" and at least one item, found none");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\n"),
            "m.wpl:3: expected 12 fields separated by tabs, found 11");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t47,5\t8\t15\t1\n"),
            "m.wpl:3: latitude must be a number with a decimal point, found \"47,5\"");
  EXPECT_EQ(refusal(home + "2\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: index must be 1, the next, found 2");
  EXPECT_EQ(
      refusal(home + "1\t0\t3\t82\t0\t0\t0\t0\t47\t8\t15\t1\n"),
      "m.wpl:3: expected waypoints (16), take-offs (22), landings (21), loitering (17, 19), a "
      "return (20) or what does not move, found command 82");
  EXPECT_EQ(refusal(home + "1\t0\t10\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: frame must be 0, 3, 5 or 6 (above sea level or home), found 10");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t97\t8\t15\t1\n"),
            "m.wpl:3: latitude and longitude must be within 90 and 180 degrees, found 97 8");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t-33\t151\t15\t1\n"),
            "m.wpl:3: expected a place near the origin 47 8, found -33 151");
  EXPECT_EQ(refusal("0\t1\t3\t22\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:2: heights above home, and no home: give the height of the ground there");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t-1\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: a hold must be >= 0 s, found -1");
  EXPECT_EQ(refusal(home + "1\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n"),
            "m.wpl: expected at least one waypoint, found none");
  std::istringstream other("QGC WPL 120\n");
  EXPECT_THROW(read_wpl(other, "m.wpl"), geom::InputError);
  std::istringstream crlf("QGC WPL 110\r\n");
  try {
    read_wpl(crlf, "m.wpl");
    FAIL();
  } catch (const geom::InputError& error) {
    EXPECT_STREQ(error.what(), "m.wpl:1: expected a line that ends with LF, found CRLF");
  }
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
      "m.plan: mission.items[0].AltitudeMode must be 1 or 2 (above home or sea level), found 3");
  EXPECT_EQ(plan_refusal("\"params\": [\n     0.0,", "\"params\": ["),
            "m.plan: mission.items[0].params must be a list of 7, found an array of 6");
  EXPECT_EQ(plan_refusal("\"command\": 22", "\"command\": \"takeoff\""),
            "m.plan: mission.items[0].command must be a finite number, found \"takeoff\"");
  EXPECT_TRUE(plan_refusal("{", "[").starts_with("m.plan: expected a JSON object"));
}

TEST(GeoLine, ComesBackToATenthOfAMillimetre) {
  const geom::GeographicFrame earth(kFrame.origin);
  GeoLine line{"a <line> & more", "note", {}};
  for (const Vec3& p : kPoints) line.points.push_back(earth.place(p));
  for (const bool kml : {true, false}) {
    std::stringstream file;
    kml ? write_kml(file, line) : write_geojson(file, line);
    const auto back = kml ? read_kml(file, "f") : read_geojson(file, "f");
    ASSERT_EQ(back.size(), kPoints.size());
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
      EXPECT_LT((earth.enu(back[i]) - kPoints[i]).norm(), 2e-4);
    }
  }
}

TEST(GeoLine, BadFilesAreRefused) {
  for (const char* text : {"", "<kml></kml>", "<LineString><coordinates></coordinates>",
                           "<LineString><coordinates>1,2</coordinates>",
                           "<LineString><coordinates>1,2,3,4</coordinates>",
                           "<LineString><coordinates>1,200,3</coordinates>"}) {
    std::istringstream in(text);
    EXPECT_THROW(read_kml(in, "f"), geom::InputError) << text;
  }
  for (const char* text :
       {"", "{}", "[]", R"({"features":[]})",
        R"({"features":[{"geometry":{"type":"Point","coordinates":[1,2,3]}}]})",
        R"({"features":[{"geometry":{"type":"LineString","coordinates":[[1,2]]}}]})"}) {
    std::istringstream in(text);
    EXPECT_THROW(read_geojson(in, "f"), geom::InputError) << text;
  }
}

TEST(GltfLine, ComesBackToSinglePrecisionAndRefusesOtherBytes) {
  std::stringstream file;
  write_gltf_line(file, kPoints, "line", "");
  const std::string bytes = file.str();
  const geom::Polyline back = read_gltf_line(file, "f");
  ASSERT_EQ(back.size(), kPoints.size());
  EXPECT_EQ(back[0], kPoints[0]);
  for (std::size_t i = 0; i < kPoints.size(); ++i) EXPECT_LT((back[i] - kPoints[i]).norm(), 1e-4);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::istringstream part(bytes.substr(0, size));
    EXPECT_THROW(read_gltf_line(part, "f"), geom::InputError) << size;
  }
}

}  // namespace
}  // namespace traj
