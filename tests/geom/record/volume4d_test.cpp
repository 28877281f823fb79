#include "geom/record/volume4d.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

const std::string kCircle =
    R"("outline_circle":{"center":{"lat":48.2,"lng":16.36},"radius":{"value":150,"units":"M"}})";
const std::string kPolygon =
    R"("outline_polygon":{"vertices":[{"lat":48.2,"lng":16.36},{"lat":48.21,"lng":16.37},{"lat":48.21,"lng":16.36}]})";

std::vector<Volume4d> read(const std::string& text) {
  return read_volumes_4d(support::Text(text), "v.json");
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

std::string altitude(const char* key, const std::string& value) {
  return std::string(",\"altitude_") + key + R"(":{"value":)" + value +
         R"(,"reference":"W84","units":"M"})";
}
std::string time(const char* key, const std::string& value) {
  return std::string(",\"time_") + key + R"(":{"value":")" + value + R"(","format":"RFC3339"})";
}
std::string volume(const std::string& space, const std::string& times = "") {
  return R"({"volume":{)" + space + "}" + times + "}";
}

TEST(Volume4d, HasWhatTheFileSays) {
  const Volume4d v =
      read(volume(kPolygon + altitude("lower", "200") + altitude("upper", "260.5"),
                  time("start", "2026-05-04T06:30:00.500Z") + time("end", "2026-05-04T07:00:00Z")))
          .at(0);
  ASSERT_EQ(v.outline.ring.size(), 3u);
  EXPECT_EQ(v.outline.ring[1].latitude, 48.21);
  EXPECT_EQ(v.outline.ring[1].longitude, 16.37);
  EXPECT_EQ(v.lower, 200);
  EXPECT_EQ(v.upper, 260.5);
  EXPECT_EQ(v.start, "2026-05-04T06:30:00.5Z");
  EXPECT_EQ(v.end, "2026-05-04T07:00:00Z");
}

TEST(Volume4d, IsOpenWhereABoundIsMissing) {
  const Volume4d v = read(volume(kCircle + R"(,"altitude_lower":null)")).at(0);
  EXPECT_TRUE(v.outline.ring.empty());
  EXPECT_EQ(v.outline.radius, 150);
  EXPECT_EQ(v.outline.centre.longitude, 16.36);
  EXPECT_FALSE(v.lower || v.upper || v.start || v.end);
}

TEST(Volumes4d, ComeInEveryFormOfTheStandard) {
  const std::string one = volume(kCircle);
  EXPECT_EQ(read("[" + one + "," + one + "]").size(), 2u);
  const std::string details =
      R"({"volumes":[)" + one + R"(],"off_nominal_volumes":[)" + one + R"(],"priority":3})";
  EXPECT_EQ(read(details).size(), 2u);
  const std::string entity = R"({"reference":{"id":"a"},"details":)" + details + "}";
  EXPECT_EQ(read(entity).size(), 2u);
  EXPECT_EQ(read(R"({"operational_intent":)" + entity + "}").size(), 2u);
  EXPECT_EQ(read(R"({"constraint":{"reference":{},"details":{"volumes":[)" + one +
                 R"(],"type":"x","geozone":null}}})")
                .size(),
            1u);
}

TEST(Volumes4d, RefuseWhatIsNotKnown) {
  EXPECT_EQ(refusal(volume(kCircle + R"(,"colour":1)")),
            "v.json: volume: expected outline_polygon, outline_circle, altitude_lower, "
            "altitude_upper, found \"colour\", which is not known here");
  EXPECT_EQ(refusal(volume(kCircle, R"(,"time_begin":1)")),
            "v.json: expected volume, time_start, time_end, found \"time_begin\", which is not "
            "known here");
  EXPECT_EQ(refusal(R"({"volumes":[)" + volume(kCircle) + R"(],"more":[]})"),
            "v.json: expected volumes, off_nominal_volumes, priority, type, geozone, found "
            "\"more\", which is not known here");
  EXPECT_EQ(refusal(R"({"type":"FeatureCollection","features":[]})"),
            "v.json: expected volume, time_start, time_end, found \"features\", which is not known "
            "here");
  for (const char* text : {"", "7", "[]", "{}", "[7]", R"({"volumes":[]})", R"({"volumes":{}})",
                           R"({"volumes":null,"off_nominal_volumes":null})",
                           R"({"constraint":{"details":{"volumes":[]}}})"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

TEST(Volumes4d, RefuseUnitsAndFormsThatAreNotSaidOrOthers) {
  EXPECT_EQ(refusal(volume(kCircle +
                           R"(,"altitude_upper":{"value":400,"reference":"W84","units":"FT"})")),
            "v.json: volume.altitude_upper.units: expected \"M\" (metres), found \"FT\"");
  EXPECT_EQ(
      refusal(volume(kCircle + R"(,"altitude_upper":{"value":400,"reference":"SFC","units":"M"})")),
      "v.json: volume.altitude_upper.reference: expected \"W84\" (above the ellipsoid of WGS "
      "84), found \"SFC\"");
  EXPECT_EQ(refusal(volume(kCircle + R"(,"altitude_upper":{"value":400,"units":"M"})")),
            "v.json: volume.altitude_upper: expected \"reference\", found none");
  EXPECT_EQ(refusal(volume(kCircle, R"(,"time_end":{"value":"2026-05-04T06:30:00Z"})")),
            "v.json: time_end: expected \"format\", found none");
  EXPECT_EQ(refusal(volume(kCircle, time("end", "2026-05-04T06:30:00+02:00"))),
            "v.json: time_end.value: expected an instant in UTC such as \"2026-05-04T06:30:00Z\" "
            "(RFC 3339), found \"2026-05-04T06:30:00+02:00\"");
  EXPECT_EQ(
      refusal(volume(
          R"("outline_circle":{"center":{"lat":48.2,"lng":16.36},"radius":{"value":1,"units":"NM"}})")),
      "v.json: volume.outline_circle.radius.units: expected \"M\" (metres), found \"NM\"");
}

TEST(Volumes4d, RefuseWhatHoldsNothing) {
  EXPECT_EQ(refusal(volume(kCircle + "," + kPolygon)),
            "v.json: volume: expected outline_polygon or outline_circle, found both");
  EXPECT_EQ(refusal("[" + volume(kCircle) + "," + volume(R"("outline_circle":null)") + "]"),
            "v.json: [1].volume: expected outline_polygon or outline_circle, found neither");
  EXPECT_EQ(refusal(volume(kCircle + altitude("lower", "9") + altitude("upper", "9"))),
            "v.json: volume: expected altitude_lower below altitude_upper, found 9 and 9");
  EXPECT_EQ(refusal(volume(kCircle, time("start", "2026-05-04T06:30:00Z") +
                                        time("end", "2026-05-04T06:30:00.0Z"))),
            "v.json: expected time_start before time_end, found 2026-05-04T06:30:00Z and "
            "2026-05-04T06:30:00Z");
  EXPECT_EQ(refusal(volume(kCircle + altitude("lower", "\"9\""))),
            "v.json: volume.altitude_lower.value: expected metres from -8000 to 100000, found "
            "\"9\"");
}

TEST(Volumes4d, RefuseRingsThatAreNone) {
  const auto ring = [](const std::string& vertices) {
    return refusal(volume(R"("outline_polygon":{"vertices":[)" + vertices + "]}"));
  };
  const std::string a = R"({"lat":48.2,"lng":16.36})";
  const std::string b = R"({"lat":48.21,"lng":16.36})";
  const std::string c = R"({"lat":48.2,"lng":16.37})";
  EXPECT_EQ(ring(a + "," + b),
            "v.json: volume.outline_polygon: expected at least 3 vertices, found 2");
  EXPECT_EQ(ring(a + "," + b + "," + b + "," + c),
            "v.json: volume.outline_polygon.vertices[2]: expected another vertex, found the one "
            "before it again");
  EXPECT_EQ(ring(a + "," + b + "," + c + "," + a),
            "v.json: volume.outline_polygon.vertices[3]: expected another vertex than the first, "
            "found it again: the last is joined to the first without that");
  EXPECT_EQ(ring(a + "," + b + R"(,{"lat":98.2,"lng":16.36})"),
            "v.json: volume.outline_polygon.vertices[2].lat: expected degrees north, within 90, "
            "found 98.2");
  EXPECT_EQ(ring(a + "," + b + R"(,{"lat":48.2,"lng":16.36,"alt":3})"),
            "v.json: volume.outline_polygon.vertices[2]: expected lat, lng, found \"alt\", which "
            "is not known here");
}

TEST(OperationalIntentDetails, ComeBackAsTheyWere) {
  Volume4d polygon;
  polygon.outline.ring = {{48.2, 16.36, 0}, {48.2 + 1e-9, 16.1, 0}, {-0.1, 1.0 / 3, 0}};
  polygon.lower = -0.1;
  polygon.upper = 1.0 / 3;
  polygon.start = "2026-05-04T06:30:00Z";
  polygon.end = "2026-05-04T06:30:00.001Z";
  Volume4d circle;
  circle.outline.centre = {48, 16, 0};
  circle.outline.radius = 0.1;
  const auto again = read(operational_intent_details(std::vector{polygon, circle}, 7));
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].outline.ring, polygon.outline.ring);
  EXPECT_EQ(again[0].lower, polygon.lower);
  EXPECT_EQ(again[0].upper, polygon.upper);
  EXPECT_EQ(again[0].start, polygon.start);
  EXPECT_EQ(again[0].end, polygon.end);
  EXPECT_EQ(again[1].outline.centre, circle.outline.centre);
  EXPECT_EQ(again[1].outline.radius, circle.outline.radius);
  EXPECT_FALSE(again[1].start);
}

TEST(ReadIntentVolumes, KeepsTheListsApart) {
  Volume4d nominal;
  nominal.outline.centre = {48, 16, 0};
  nominal.outline.radius = 3;
  Volume4d off = nominal;
  off.outline.radius = 5;
  const std::string text =
      operational_intent_details(std::vector{nominal}, 7, std::vector{off, off});
  const IntentVolumes read_both = read_intent_volumes(support::Text(text), "v.json");
  ASSERT_EQ(read_both.nominal.size(), 1u);
  ASSERT_EQ(read_both.off_nominal.size(), 2u);
  EXPECT_EQ(read_both.nominal[0].outline.radius, 3);
  EXPECT_EQ(read_both.off_nominal[1].outline.radius, 5);
  EXPECT_EQ(read(text).size(), 3u);
  const std::string only_off = operational_intent_details({}, {}, std::vector{off});
  EXPECT_EQ(read(only_off).size(), 1u);
}

}  // namespace
}  // namespace geom
