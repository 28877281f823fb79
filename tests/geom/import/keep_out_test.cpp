#include "geom/import/keep_out.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "support/reading.h"

namespace geom {
namespace {

using support::says;
using support::Text;

Frame at(double latitude, double longitude) {
  return {Axes::enu, GeodeticOrigin{latitude, longitude, 0}, ""};
}

// Points along edges of 40 km in degrees, far more than the reader takes.
TEST(KeepOut, FollowsEdgesThatBend) {
  const double corners[][2] = {{24.5, 59.9}, {25.3, 59.9}, {25.2, 60.2}, {24.6, 60.3}};
  std::string ring;
  for (int i = 0; i <= 4; ++i) {
    ring += (i ? ",[" : "[") + std::to_string(corners[i % 4][0]) + "," +
            std::to_string(corners[i % 4][1]) + "]";
  }
  const KeepOut zones = read_keep_out(Text(R"({"type":"Polygon","coordinates":[[)" + ring + "]]}"),
                                      "zones", at(60, 25), {false, 0, 9});
  EXPECT_LT(zones.bulge[0], 0.01);
  const GeographicFrame frame({60, 25, 0});
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k <= 5000; ++k) {
      const auto along = [&](int axis) {
        return corners[i][axis] + (corners[(i + 1) % 4][axis] - corners[i][axis]) * (k / 5000.0);
      };
      Vec2 p;
      frame.from_geodetic(along(1), along(0), p.x(), p.y());
      ASSERT_LE(distance(zones.volumes[0].polygon, p), zones.bulge[0] + 1e-6);
    }
  }
}

TEST(KeepOut, StandsWhereItsDegreesSay) {
  const KeepOut zones = read_keep_out(
      Text(
          R"({"type":"Feature","properties":{"lower":10,"upper":50,"name":"port"},"geometry":
         {"type":"Polygon","coordinates":[[[25,60],[25.001,60],[25.001,60.001],[25,60.001],[25,60]]]}})"),
      "zones", at(60, 25), {});
  ASSERT_EQ(zones.volumes.size(), 1u);
  EXPECT_EQ(zones.labels[0], "keep-out: port");
  EXPECT_EQ(zones.volumes[0].bottom, 10);
  EXPECT_EQ(zones.volumes[0].top, 50);
  EXPECT_NEAR(zones.volumes[0].polygon.outer[2].x(), 55.80, 0.01);
  EXPECT_NEAR(zones.volumes[0].polygon.outer[2].y(), 111.41, 0.01);
}

TEST(KeepOut, RefusesDegreesOfAnotherKind) {
  const std::string crs = R"("crs":{"type":"name","properties":{"name":"EPSG:3857"}},)";
  const std::string polygon =
      R"("type":"Polygon","coordinates":[[[25,60],[25.001,60],[25,60.001],[25,60]]]})";
  for (const std::string& text :
       {"{" + crs + polygon, R"({"type":"Feature",)" + crs + R"("geometry":{)" + polygon + "}",
        R"({"type":"Feature","geometry":{)" + crs + polygon + "}",
        R"({"type":"FeatureCollection",)" + crs + R"("features":[{"geometry":{)" + polygon +
            "}]}"}) {
    EXPECT_TRUE(
        says(support::refusal_of([&] { read_keep_out(Text(text), "zones", at(60, 25), {}); }),
             "zones: crs must be CRS84"))
        << text;
    EXPECT_EQ(read_keep_out(Text(text), "zones", at(60, 25), {.local = true}).volumes.size(), 1u);
  }
}

KeepOut timed(const std::string& properties, const KeepOutOptions& options,
              const std::string& more = "") {
  return read_keep_out(
      Text(R"({"type":"FeatureCollection",)" + more +
           R"("features":[{"type":"Feature","properties":{"lower":1,"upper":9)" + properties +
           R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}}]})"),
      "zones", {}, options);
}

const KeepOutOptions kTimed{true, 0, 9, "2026-05-04T06:30:00Z"};

TEST(KeepOut, IsThereWhenItsTimesSay) {
  const auto time = [](const std::string& properties) {
    return timed(properties, kTimed).times.at(0);
  };
  const TimeSpan always;
  EXPECT_TRUE(time("").always());
  EXPECT_TRUE(time(R"(,"from":null,"until":null)").always());
  EXPECT_EQ(time(R"(,"from":-60.5)"), (TimeSpan{-60.5, always.until}));
  EXPECT_EQ(time(R"(,"until":60)"), (TimeSpan{always.from, 60}));
  EXPECT_EQ(time(R"(,"from":"2026-05-04T06:30:00Z","until":"2026-05-05T06:30:01+00:00")"),
            (TimeSpan{0, 86401}));
  const TimeSpan part =
      time(R"(,"from":"2026-05-04T06:30:00.1Z","until":"2026-05-04T06:30:00.1Z")");
  EXPECT_LT(part.from, 0.1);
  EXPECT_GT(part.until, 0.1);
  EXPECT_NEAR(part.from, part.until, 1e-14);
}

TEST(KeepOut, SaysWhetherAVolumeReachesToTheEndOfTheMap) {
  const auto open = [](const std::string& properties) {
    const KeepOut zones = read_keep_out(
        Text(R"({"type":"Feature","properties":{)" + properties +
             R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})"),
        "zones", {}, kTimed);
    return std::pair(zones.open_below, zones.open_above);
  };
  EXPECT_EQ(open(""), std::pair(true, true));
  EXPECT_EQ(open(R"("lower":3)"), std::pair(false, true));
  EXPECT_EQ(open(R"("lower":null,"upper_altitude_m":30)"), std::pair(true, false));
  EXPECT_EQ(open(R"("lower":3,"upper":30)"), std::pair(false, false));
}

TEST(KeepOut, RefusesTimesThatCannotBe) {
  const auto refusal = [](const std::string& properties, const KeepOutOptions& options = kTimed,
                          const std::string& more = "") {
    return support::refusal_of([&] { timed(properties, options, more); });
  };
  EXPECT_TRUE(says(refusal(R"(,"from":"2026-05-04")"), "found \"2026-05-04\""));
  EXPECT_TRUE(says(refusal(R"(,"from":"12")"), "seconds after the epoch"));
  EXPECT_TRUE(says(refusal(R"(,"until":true)"), "until must be seconds"));
  EXPECT_TRUE(says(refusal(R"(,"from":5,"until":4)"), "from must be at most until, found 5 and 4"));
  EXPECT_TRUE(says(refusal(R"(,"until":1777876200)"), "within 1e+09"));
  EXPECT_TRUE(says(refusal(R"(,"from":"1960-01-01T00:00:00Z")"), "within 1e+09"));
  EXPECT_TRUE(says(refusal(R"(,"until":4)", {.local = true}), "give --epoch"));
  const std::string other = R"("epoch":"2026-05-04T06:31:00Z",)";
  EXPECT_TRUE(says(refusal("", kTimed, other), "expected the epoch of the map"));
  EXPECT_TRUE(says(refusal("", {.local = true}, other), "which has none"));
  EXPECT_EQ(refusal("", kTimed, R"("epoch":"2026-05-04T06:30:00.0Z",)"), "");
  EXPECT_TRUE(
      says(refusal(R"(,"from":100,"epoch":"2026-05-04T07:30:00Z")"), "the epoch of the map"));
  EXPECT_EQ(refusal(R"(,"from":100,"epoch":"2026-05-04T06:30:00Z")"), "");
  EXPECT_EQ(refusal(R"(,"epoch":2020.5)", {.local = true}), "");  // of nothing here
}

TEST(KeepOut, RefusesWhatIsNoVolume) {
  for (
      const char* text :
      {"", "[]", R"({"type":"Point","coordinates":[1,2]})",
       R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]})",
       R"({"type":"Polygon","coordinates":[[[0,0],[200,1],[1,1],[0,0]]]})",
       R"({"type":"Feature","properties":{"lower":9,"upper":3},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})"}) {
    EXPECT_THROW(read_keep_out(Text(text), "zones", at(60, 25), {}), InputError) << text;
  }
  EXPECT_THROW(
      read_keep_out(Text(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})"),
                    "zones", {}, {}),
      InputError);
}

}  // namespace
}  // namespace geom
