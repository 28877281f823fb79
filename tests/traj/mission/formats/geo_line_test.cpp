#include "traj/mission/formats/geo_line.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/reading.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::kFrame;
using testing::kPoints;

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

TEST(GeoLine, ReadsEveryLine) {
  const std::string line =
      "<LineString><altitudeMode>absolute</altitudeMode><coordinates>1,2,3 "
      "1,2,4</coordinates></LineString>";
  EXPECT_EQ(read_kml(support::Text("<kml><Placemark>" + line +
                                   "</Placemark><Folder><Placemark><MultiGeometry>" + line + line +
                                   "</MultiGeometry></Placemark></Folder></kml>"),
                     "f")
                .size(),
            3u);
  const auto lines = read_geojson(
      support::Text(
          R"({"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[1,2,3]]},
          {"type":"MultiLineString","coordinates":[[[1,2,3]],[[4,5,6],[7,8,9]]]}]})"),
      "f");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2][1].longitude, 7);
  EXPECT_EQ(lines[2][1].latitude, 8);
  EXPECT_EQ(lines[2][1].height, 9);
}

TEST(GeoLine, RefusalsSayWhereAndWhat) {
  const auto kml = [](const std::string& text) {
    return support::refusal_of([&] { read_kml(support::Text(text), "f"); });
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
            "f:2: expected nothing more after the root element, found \"<kml/>\"");
  EXPECT_EQ(kml("<gpx/>"), "f:1: expected KML, found <gpx>");
  const auto json = [](const std::string& text) {
    return support::refusal_of([&] { read_geojson(support::Text(text), "f"); });
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
    EXPECT_THROW(read_kml(support::Text(text), "f"), geom::InputError) << text;
  }
  for (const char* text :
       {"", "{}", "[]", R"({"features":[]})",
        R"({"features":[{"geometry":{"type":"Point","coordinates":[1,2,3]}}]})",
        R"({"features":[{"geometry":{"type":"LineString","coordinates":[[1,2]]}}]})"}) {
    EXPECT_THROW(read_geojson(support::Text(text), "f"), geom::InputError) << text;
  }
}

}  // namespace
}  // namespace traj
