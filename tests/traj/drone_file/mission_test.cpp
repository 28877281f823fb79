#include "traj/drone_file/mission.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/refusal.h"
#include "traj/drone_file/geo_line.h"
#include "traj/drone_file/gltf_line.h"
#include "traj/drone_file/qgc_plan.h"
#include "traj/drone_file/wpl.h"

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
                                 "5\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n");
  ASSERT_EQ(flown.path.size(), 3u);
  EXPECT_LT((flown.path[0] - Vec3(0, 0, 25)).norm(), 1e-6);
  EXPECT_NEAR(flown.path[1].y(), 111.17, 0.05);
  EXPECT_EQ(flown.path[1].z(), 30);
  EXPECT_EQ(flown.path[2].z(), 40) << "above the sea";
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 9, 0}));
  EXPECT_TRUE(flown.returns);
  EXPECT_TRUE(flown.ended);
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
      "return (20), delays (93), speeds (178) or what is known to move nothing, found command 82");
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

TEST(GeoLine, ComesBackToATenthOfAMillimetre) {
  const geom::GeographicFrame earth(kFrame.origin);
  GeoLine line{"a <line> & more", "note", {}};
  for (const Vec3& p : kPoints) line.points.push_back(earth.place(p));
  for (const bool kml : {true, false}) {
    std::stringstream file;
    kml ? write_kml(file, line) : write_geojson(file, line);
    const auto back = kml ? read_kml(file, "f") : read_geojson(file, "f");
    ASSERT_EQ(back.size(), 1u);
    ASSERT_EQ(back[0].size(), kPoints.size());
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
      EXPECT_LT((earth.enu(back[0][i]) - kPoints[i]).norm(), 2e-4);
    }
  }
}

TEST(Wpl, KnowsWhatEndsWhatCutsCornersAndWhatSpeedIsSaid) {
  const std::string takeoff = std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n";
  const std::string corner = takeoff + "2\t0\t3\t16\t0\t2\t0\t0\t47.001\t8\t15\t1\n" +
                             "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8.001\t15\t1\n";
  EXPECT_TRUE(fly(corner).cuts_corners);
  EXPECT_FALSE(fly(corner).ended);
  EXPECT_FALSE(fly(corner).speed);
  const std::string speed = takeoff + "2\t0\t2\t178\t1\t5\t-1\t0\t0\t0\t0\t1\n";
  const std::string rest = speed + "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8\t15\t1\n" +
                           "4\t0\t3\t21\t0\t0\t0\t0\t47.001\t8\t0\t1\n";
  EXPECT_FALSE(fly(rest).cuts_corners);
  EXPECT_TRUE(fly(rest).ended);
  EXPECT_EQ(fly(rest).speed, 5);
  EXPECT_EQ(fly(rest).takeoff_from_home, 0);
  const FlownMission away =
      fly(std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t47.0001\t8\t15\t1\n");
  ASSERT_EQ(away.path.size(), 2u) << "up at home, then there";
  EXPECT_LT((away.path[0] - Vec3(0, 0, 25)).norm(), 1e-6);
  EXPECT_NEAR(away.takeoff_from_home, 11.1, 0.1);
}

TEST(Wpl, WhatIsNotKnownToMoveNothingIsRefused) {
  const std::string takeoff = std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n";
  std::size_t passed = 0;
  for (int command = 0; command < 40000; ++command) {
    const std::string items =
        takeoff + "2\t0\t3\t" + std::to_string(command) + "\t1\t0\t0\t0\t47.001\t8\t15\t1\n";
    if (refusal(items).empty()) ++passed;
  }
  EXPECT_EQ(passed, 31u + 7u) << "what is listed, and 16, 17, 19, 20, 21, 93, 178";
}

TEST(GeoLine, ReadsEveryLine) {
  const std::string line =
      "<LineString><altitudeMode>absolute</altitudeMode><coordinates>1,2,3 "
      "1,2,4</coordinates></LineString>";
  std::istringstream kml("<kml><Placemark>" + line +
                         "</Placemark><Folder><Placemark><MultiGeometry>" + line + line +
                         "</MultiGeometry></Placemark></Folder></kml>");
  EXPECT_EQ(read_kml(kml, "f").size(), 3u);
  std::istringstream json(
      R"({"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[1,2,3]]},
          {"type":"MultiLineString","coordinates":[[[1,2,3]],[[4,5,6],[7,8,9]]]}]})");
  const auto lines = read_geojson(json, "f");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2][1].longitude, 7);
  EXPECT_EQ(lines[2][1].latitude, 8);
  EXPECT_EQ(lines[2][1].height, 9);
}

TEST(GeoLine, RefusalsSayWhereAndWhat) {
  const auto kml = [](const std::string& text) {
    std::istringstream in(text);
    return support::refusal_of([&] { read_kml(in, "f"); });
  };
  EXPECT_EQ(
      kml("<kml>\n<Point/></kml>"),
      "f:2: expected LineStrings, found <Point>, which is no line that could be flown: remove "
      "it");
  EXPECT_EQ(kml("<kml>\n<LineString><coordinates>1,2,3</coordinates></LineString></kml>"),
            "f:2: expected altitudeMode absolute, found none, which means on the ground: give "
            "heights above the sea and say so");
  EXPECT_EQ(kml("<kml><Document>\n"),
            "f:2: the element of line 1 is not ended: the file may be cut");
  EXPECT_EQ(kml("<kml></Document>"),
            "f:1: expected the end of the element of line 1, found another's");
  EXPECT_EQ(kml("<kml/>\n<kml/>"),
            "f:2: expected nothing more after the root element, found another");
  EXPECT_EQ(kml("<gpx/>"), "f:1: expected KML, found <gpx>");
  const auto json = [](const std::string& text) {
    std::istringstream in(text);
    return support::refusal_of([&] { read_geojson(in, "f"); });
  };
  EXPECT_EQ(json(R"({"type":"Feature","geometry":{"type":"Point"}})"),
            "f: the file.geometry: expected LineStrings, found Point, which is no line that could "
            "be flown: remove it");
  EXPECT_EQ(json("{\n\"type\":"),
            "f:2: column 8: this is not JSON: expected a value, found the end");
  EXPECT_EQ(json("{}\n{}"),
            "f:2: column 1: this is not JSON: expected nothing after the value, found {");
  EXPECT_EQ(json(R"({"type":"Feature","type":"Point"})"),
            "f:1: column 19: expected each key once, found \"type\" again");
  EXPECT_EQ(json(std::string(200000, '[')),
            "f:1: column 101: expected lists and objects nested at most 100 deep, found more");
}

TEST(GeoLine, BadFilesAreRefused) {
  for (const char* text :
       {"", "<kml></kml>", "<kml>&lol;</kml>", "<kml a=b/>", "<kml a='<'/>", "<kml>&#0;</kml>",
        "<kml>&#xd800;</kml>", "<kml><a></kml></a>", "<LineString><coordinates></coordinates>",
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
  const auto lines = read_gltf_lines(file, "f");
  ASSERT_EQ(lines.size(), 1u);
  const geom::Polyline& back = lines[0];
  ASSERT_EQ(back.size(), kPoints.size());
  EXPECT_EQ(back[0], kPoints[0]);
  for (std::size_t i = 0; i < kPoints.size(); ++i) EXPECT_LT((back[i] - kPoints[i]).norm(), 1e-4);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::istringstream part(bytes.substr(0, size));
    EXPECT_THROW(read_gltf_lines(part, "f"), geom::InputError) << size;
  }
}

}  // namespace
}  // namespace traj
