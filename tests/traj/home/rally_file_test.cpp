#include "traj/home/rally_file.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

using geom::Vec3;
using support::says;

const geom::Frame kFrame{.axes = geom::Axes::enu, .origin = geom::GeodeticOrigin{47.4, 8.5, 400}};

std::vector<Vec3> read(const std::string& text, const geom::Frame& frame = kFrame) {
  return read_rally(support::Text(text), "r.geojson", frame);
}

std::string refusal(const std::string& text, const geom::Frame& frame = kFrame) {
  return support::refusal_of([&] { read(text, frame); });
}

const std::string kPoint = R"({"type":"Point","coordinates":[8.501,47.402,440]})";

TEST(ReadRally, TakesPointsFeaturesAndCollections) {
  const std::string feature = R"({"type":"Feature","properties":{},"geometry":)" + kPoint + "}";
  EXPECT_EQ(read(kPoint).size(), 1u);
  EXPECT_EQ(read(feature).size(), 1u);
  const auto two =
      read(R"({"type":"FeatureCollection","features":[)" + feature + "," + feature + "]}");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0].x(), 75.5, 0.1);
  EXPECT_NEAR(two[0].y(), 222.4, 0.1);
  EXPECT_NEAR(two[0].z(), 40, 1e-9);
}

TEST(ReadRally, GivesPlacesInTheAxesOfTheMap) {
  geom::Frame frame = kFrame;
  frame.axes = geom::Axes::neu;
  EXPECT_EQ(read(kPoint, frame)[0], geom::to_enu(geom::Axes::neu, read(kPoint)[0]));
}

TEST(ReadRally, RefusesWhatIsNoRallyPoint) {
  EXPECT_TRUE(says(refusal(R"({"type":"Point","coordinates":[8.5,47.4]})"), "metres above"));
  EXPECT_TRUE(says(refusal(R"({"type":"LineString","coordinates":[]})"), "Point"));
  EXPECT_TRUE(says(refusal(R"({"type":"FeatureCollection","features":[]})"), "at least one"));
  EXPECT_TRUE(says(refusal(R"({"type":"FeatureCollection","features":3})"), "a list"));
  EXPECT_TRUE(says(refusal(R"({"type":"Point","coordinates":[47.4,8.5,440]})"), "near the origin"));
  EXPECT_TRUE(says(refusal("[]"), "\"type\""));
  EXPECT_TRUE(says(refusal(kPoint, geom::Frame{}), "origin"));
}

}  // namespace
}  // namespace traj
