#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/home/landing_site.h"

namespace traj {
namespace {

using support::says;

const geom::Frame kOnEarth{geom::Axes::enu, geom::GeodeticOrigin{48.2, 16.4, 150}, ""};

std::vector<DrawnSite> read(const std::string& json, bool local = false,
                            const geom::Frame& frame = kOnEarth) {
  return read_sites(support::Text(json), "sites.geojson", frame, {local});
}

std::string point(const std::string& coordinates, const std::string& properties = "{}") {
  return R"({"type":"Feature","properties":)" + properties +
         R"(,"geometry":{"type":"Point","coordinates":)" + coordinates + "}}";
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string refused(const std::string& json, bool local = true) {
  return support::refusal_of([&] { read(json, local); });
}

TEST(ReadSites, TakesPointsAndPolygonsWithTheirNames) {
  const auto sites = read(
      collection(point("[1,2,3]", R"({"name":"a"})") + "," + point("[4,5]", R"({"ground":7})") +
                 R"(,{"type":"Feature","id":9,"geometry":{"type":"Polygon","coordinates":)"
                 R"([[[0,0],[9,0],[9,9],[0,0]]]}})"),
      true);
  ASSERT_EQ(sites.size(), 3u);
  EXPECT_EQ(sites[0].id, "a");
  EXPECT_EQ(sites[0].outline.outer.front(), geom::Vec2(1, 2));
  EXPECT_EQ(sites[0].ground, 3);
  EXPECT_EQ(sites[1].id, "site-2");
  EXPECT_EQ(sites[1].ground, 7);
  EXPECT_EQ(sites[2].id, "9");
  EXPECT_EQ(sites[2].outline.outer.size(), 4u);
  EXPECT_FALSE(sites[2].ground);
}

TEST(ReadSites, PlacesDegreesAndHeightsAsTheOriginCountsThem) {
  const auto sites = read(point("[16.4,48.2,160]"));
  EXPECT_LT(sites[0].outline.outer.front().norm(), 1e-6);
  EXPECT_EQ(sites[0].ground, 10);
  EXPECT_TRUE(says(support::refusal_of([&] { read(point("[1,2]"), false, {}); }), "--home-local"));
  EXPECT_TRUE(says(refused(point("[48.2,16.4]"), false), "longitude, latitude"));
}

TEST(ReadSites, RefusesWhatIsNoSite) {
  EXPECT_NE(refused("[]"), "");
  EXPECT_TRUE(says(refused(collection("")), "at least one landing site"));
  EXPECT_TRUE(says(refused(point("[1]")), "feature 1: a position"));
  EXPECT_NE(refused(point("[1,\"2\"]")), "");
  EXPECT_TRUE(says(refused(point("[1,2]", R"({"ground":"low"})")), "ground"));
  EXPECT_TRUE(says(refused(point("[1,2,3]", R"({"ground":5})")), "ground"));
  EXPECT_TRUE(says(
      refused(collection(point("[1,2]", R"({"id":"a"})") + "," + point("[3,4]", R"({"id":"a"})"))),
      "feature 2"));
  EXPECT_TRUE(says(refused(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})"), "Polygon"));
  EXPECT_TRUE(says(refused(R"({"type":"Polygon","coordinates":[[[0,0],[1,1]]]})"), "4 positions"));
  EXPECT_TRUE(says(refused(R"({"type":"Point","coordinates":[1,2],)"
                           R"("crs":{"properties":{"name":"EPSG:25833"}}})",
                           false),
                   "crs"));
}

}  // namespace
}  // namespace traj
