#include "geom/zone/read_zones.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"

namespace geom {
namespace {

using Json = nlohmann::json;

Json ed269_zone() {
  return Json::parse(R"({"identifier":"CH-1","country":"CHE","name":"Port","type":"COMMON",
    "restriction":"REQ_AUTHORISATION","reason":["OTHER"],"message":"Ask first",
    "zoneAuthority":[{"name":"Police","email":"a@b.example","purpose":"AUTHORIZATION",
                      "intervalBefore":"P2D"}],
    "applicability":[{"permanent":"YES"}],
    "geometry":[{"uomDimensions":"M","lowerLimit":30,"lowerVerticalReference":"AGL",
                 "upperLimit":99999,"upperVerticalReference":"AMSL","horizontalProjection":{
                 "type":"Polygon","coordinates":[[[8,47],[8.1,47],[8.1,47.1],[8,47.1],[8,47]]]}}]})");
}

ZoneFile ed269(const Json& zone) {
  return read_zones(Json{{"features", {zone}}}.dump(), "zones.json");
}

Json ed318_feature() {
  return Json::parse(R"({"type":"Feature","geometry":{"type":"Point","coordinates":[2.6,50.1],
    "extent":{"subType":"Circle","radius":3500},"layer":{"upper":400,"upperReference":"AGL",
    "lower":50,"lowerReference":"WGS84","uom":"ft"}},
    "properties":{"identifier":"ABC","country":"FRA","type":"PROHIBITED","variant":"COMMON",
    "zoneAuthority":[{"purpose":"INFORMATION"}],
    "limitedApplicability":[{"startDateTime":"2026-05-04T08:00:00+02:00","schedule":[
      {"day":["MON","SUN"],"startEvent":"SR","endTime":"17:00:00Z"}]}]}})");
}

Json collection(const Json& feature) {
  return {{"type", "FeatureCollection"},
          {"metadata", {{"issued", "2026-05-01T00:00:00Z"}}},
          {"features", {feature}}};
}

ZoneFile ed318(const Json& feature) { return read_zones(collection(feature).dump(), "zones.json"); }

Fault refused(const Json& root) {
  try {
    read_zones(root.dump(), "zones.json");
  } catch (const InputError& error) {
    return error.fault();
  }
  return {};
}

Fault refused_zone(const Json& zone) { return refused(Json{{"features", {zone}}}); }

TEST(ReadZones, ReadAZoneOfEd269) {
  const ZoneFile file = ed269(ed269_zone());
  EXPECT_EQ(file.format, "ed-269");
  const Zone& zone = file.zones.at(0);
  EXPECT_EQ(zone.identifier, "CH-1");
  EXPECT_EQ(zone.type, ZoneType::authorization);
  EXPECT_TRUE(zone.periods.empty());
  EXPECT_EQ(zone.volumes.at(0).outline.ring.size(), 4U);
  EXPECT_EQ(zone.volumes[0].lower->metres, 30);
  EXPECT_FALSE(zone.volumes[0].upper) << "99999 stands for none";
  EXPECT_EQ(zone.authority, "Police, a@b.example, AUTHORIZATION, P2D before");
  EXPECT_EQ(zone.message, "Ask first");
}

TEST(ReadZones, ReadACircleOfEd318InFeetByTheSun) {
  const ZoneFile file = ed318(ed318_feature());
  EXPECT_EQ(file.format, "ed-318");
  EXPECT_EQ(file.issued, "2026-05-01T00:00:00Z");
  const Zone& zone = file.zones.at(0);
  EXPECT_EQ(zone.volumes.at(0).outline.radius, 3500);
  EXPECT_NEAR(zone.volumes[0].upper->metres, 121.92, 1e-9);
  EXPECT_EQ(zone.volumes[0].lower->from, HeightReference::ellipsoid);
  const ZonePeriod& period = zone.periods.at(0);
  EXPECT_EQ(period.start, "2026-05-04T06:00:00Z");
  EXPECT_FALSE(period.end);
  EXPECT_EQ(period.schedule.at(0).days, 0b1000001);
  EXPECT_EQ(period.schedule[0].begin->event, DayEvent::sunrise);
  EXPECT_EQ(period.schedule[0].end->least, 17 * 3600);
  EXPECT_EQ(period.schedule[0].end->most, 17 * 3600 + 1) << "to the end of the second";
}

TEST(ReadZones, ReadAMarkOfByteOrderAndAListWithAnotherName) {
  const std::string text = "\xef\xbb\xbf" + Json{{"UASZoneList", {ed269_zone()}}}.dump();
  EXPECT_EQ(read_zones(text, "zones.json").zones.size(), 1U);
}

TEST(ReadZones, ReadLimitsThatAreTextOrNull) {
  Json zone = ed269_zone();
  zone["geometry"][0]["lowerLimit"] = "0";
  zone["geometry"][0]["upperLimit"] = nullptr;
  const ZoneFile file = ed269(zone);
  EXPECT_EQ(file.zones[0].volumes[0].lower->metres, 0);
  EXPECT_FALSE(file.zones[0].volumes[0].upper);
}

TEST(ReadZones, TakeFeetOfACircleForMetresOfItsRadius) {
  Json zone = ed269_zone();
  zone["geometry"][0]["uomDimensions"] = "FT";
  zone["geometry"][0]["horizontalProjection"] =
      Json{{"type", "Circle"}, {"center", {8, 47}}, {"radius", 500}};
  const ZoneFile file = ed269(zone);
  EXPECT_EQ(file.zones[0].volumes[0].outline.radius, 500);
  EXPECT_EQ(file.warnings.size(), 1U);
}

TEST(ReadZones, GiveTwoZonesACellOfTheFaa) {
  const std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature",
    "properties":{"OBJECTID":2,"CEILING":200,"APT1_ICAO":"KLGA","MAP_EFF":"2026-06-12"},
    "geometry":{"type":"Polygon","coordinates":[[[-73,40],[-72.9,40],[-72.9,40.1],[-73,40]]]}}]})";
  const ZoneFile file = read_zones(text, "grid.json");
  ASSERT_EQ(file.zones.size(), 2U);
  EXPECT_EQ(file.issued, "2026-06-12");
  EXPECT_EQ(file.zones[0].identifier, "KLGA/2");
  EXPECT_EQ(file.zones[0].type, ZoneType::authorization);
  EXPECT_NEAR(file.zones[0].volumes[0].upper->metres, 60.96, 1e-9);
  EXPECT_EQ(file.zones[1].type, ZoneType::prohibited);
  EXPECT_NEAR(file.zones[1].volumes[0].lower->metres, 60.96, 1e-9);
  EXPECT_FALSE(file.zones[1].volumes[0].upper);
}

TEST(ReadZones, ObeyTheUnitOfACeiling) {
  const auto with = [](const char* unit) {
    return std::string(R"({"type":"FeatureCollection","features":[{"type":"Feature",
      "properties":{"OBJECTID":2,"CEILING":200,"UNIT":)") +
           unit + R"(},"geometry":{"type":"Polygon",
      "coordinates":[[[-73,40],[-72.9,40],[-72.9,40.1],[-73,40]]]}}]})";
  };
  EXPECT_EQ(read_zones(with("\"Feet\""), "grid.json").zones[0].authority, "FAA");
  EXPECT_EQ(read_zones(with("\"LGA ATCT\""), "grid.json").zones[0].authority, "FAA, LGA ATCT");
  EXPECT_THROW(read_zones(with("\"Meters\""), "grid.json"), InputError);
  EXPECT_THROW(read_zones(with("1"), "grid.json"), InputError);
}

TEST(ReadZones, WarnOfARingThatCrossesItself) {
  Json zone = ed269_zone();
  zone["geometry"][0]["horizontalProjection"]["coordinates"] =
      Json::parse("[[[8,47],[8.1,47.1],[8.1,47],[8,47.1],[8,47]]]");
  EXPECT_EQ(ed269(zone).warnings.size(), 1U);
}

TEST(ReadZones, ObeyAPermanentThatIsAYesOfJson) {
  Json zone = ed269_zone();
  zone["applicability"] = Json::parse(
      R"([{"permanent":true,"startDateTime":"2020-01-01T00:00:00Z","endDateTime":"2020-02-01T00:00:00Z"}])");
  EXPECT_TRUE(ed269(zone).zones[0].periods.empty()) << "it is always there";
  zone["applicability"][0]["permanent"] = false;
  EXPECT_EQ(ed269(zone).zones[0].periods.size(), 1U);
}

TEST(ReadZones, ReadTheTimesOfBothLists) {
  Json zone = ed269_zone();
  zone["applicability"] = Json::parse(R"([{"schedule":[{"day":["MON"],"startTime":"08:00Z"}],
    "dailyPeriod":[{"day":["SUN"],"startTime":"09:00Z"}]}])");
  const ZonePeriod period = ed269(zone).zones.at(0).periods.at(0);
  ASSERT_EQ(period.schedule.size(), 2U);
  EXPECT_EQ(period.schedule[0].days, 1);
  EXPECT_EQ(period.schedule[1].days, 64);
}

// What a member that nobody knows says may be that the zone is there at other times, too.
TEST(ReadZones, AMemberOfItsTimesThatIsNotKnownMeansAlways) {
  const Json times = Json::parse(
      R"([{"startDateTime":"2026-05-04T08:00:00Z","endDateTime":"2026-05-04T09:00:00Z"}])");
  for (const Json& more : {Json{{"permanent", "YES"}}, Json{{"repeats", "yearly"}}}) {
    Json zone = ed269_zone();
    zone["applicability"] = times;
    zone["applicability"][0].update(more);
    EXPECT_TRUE(ed269(zone).zones.at(0).periods.empty()) << more;
    Json feature = ed318_feature();
    feature["properties"]["limitedApplicability"] = times;
    feature["properties"]["limitedApplicability"][0].update(more);
    const ZoneFile file = ed318(feature);
    EXPECT_TRUE(file.zones.at(0).periods.empty()) << more;
    EXPECT_EQ(file.warnings.size(), more.contains("repeats") ? 1U : 0U);
  }
  Json feature = ed318_feature();
  feature["properties"]["limitedApplicability"][0]["schedule"][0]["timeZone"] = "Europe/Berlin";
  const DailyPeriod daily = ed318(feature).zones.at(0).periods.at(0).schedule.at(0);
  EXPECT_EQ(daily.days, kEveryDay);
  EXPECT_FALSE(daily.begin || daily.end);
}

TEST(ReadZones, RefuseWhatCannotBeReadAndNameTheZone) {
  const auto with = [](const char* pointer, const Json& value) {
    Json zone = ed269_zone();
    zone[Json::json_pointer(pointer)] = value;
    return refused_zone(zone);
  };
  EXPECT_EQ(with("/restriction", "FORBIDDEN").item, "zone \"CH-1\"");
  EXPECT_EQ(with("/restriction", "FORBIDDEN").found, "\"FORBIDDEN\"");
  EXPECT_EQ(with("/geometry/0/uomDimensions", "FL").key, "uomDimensions");
  EXPECT_EQ(with("/geometry/0/lowerVerticalReference", "STD").key, "lowerVerticalReference");
  EXPECT_EQ(with("/geometry/0/lowerLimit", "low").key, "lowerLimit");
  EXPECT_EQ(with("/geometry/0/horizontalProjection/type", "LineString").found, "\"LineString\"");
  EXPECT_EQ(with("/geometry/0/horizontalProjection/coordinates/0/1", Json{200, 47}).key,
            "a position");
  EXPECT_EQ(with("/geometry", Json::array()).key, "geometry");
  EXPECT_EQ(with("/identifier", nullptr).key, "identifier");
  EXPECT_EQ(with("/applicability/0/permanent", "SOMETIMES").key, "permanent");
  EXPECT_EQ(with("/applicability/0/permanent", 1).key, "permanent");
  const auto period = [&](const char* text) { return with("/applicability", Json::parse(text)); };
  EXPECT_EQ(period(R"([{"permanent":"NO","startDateTime":"2026-05-04T08:00:00"}])").key,
            "startDateTime")
      << "a time without an offset may be any";
  EXPECT_EQ(period(R"([{"schedule":[{"day":["HOL"]}]}])").key, "day");
  EXPECT_EQ(period(R"([{"schedule":[{"startTime":"08:00"}]}])").key, "startTime");
  EXPECT_EQ(period(R"([{"schedule":[{"startTime":"25:00Z"}]}])").key, "startTime");
  EXPECT_EQ(
      period(R"([{"startDateTime":"2026-05-04T08:00:00Z","endDateTime":"2026-05-04T07:00:00Z"}])")
          .key,
      "endDateTime");
}

TEST(ReadZones, RefuseAnEventOfTheSunThatNobodyKnowsAndAPointWithoutExtent) {
  Json feature = ed318_feature();
  feature["properties"]["limitedApplicability"][0]["schedule"][0]["startEvent"] = "NOON";
  EXPECT_EQ(refused(collection(feature)).key, "startEvent");
  feature = ed318_feature();
  feature["geometry"].erase("extent");
  EXPECT_EQ(refused(collection(feature)).key, "a Point");
  Json metadata = collection(ed318_feature());
  metadata["metadata"]["validFrom"] = Json{{"purposely_invalid", "no instant"}};
  EXPECT_EQ(refused(metadata).key, "validFrom");
}

TEST(ReadZones, RefuseInvertedLimitsOfOneReferenceOnly) {
  Json zone = ed269_zone();
  zone["geometry"][0]["upperLimit"] = 20;
  EXPECT_EQ(ed269(zone).zones[0].volumes[0].upper->metres, 20) << "of the ground and the sea";
  zone["geometry"][0]["upperVerticalReference"] = "AGL";
  EXPECT_EQ(refused_zone(zone).key, "the lower limit");
}

TEST(ReadZones, RefuseOtherGeoJson) {
  const std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature",
    "properties":{"lower":1},"geometry":null}]})";
  EXPECT_THROW(read_zones(text, "zones.geojson"), InputError);
}

TEST(ZoneFormats, AreToldByNoBeginning) {
  EXPECT_EQ(zone_formats().size(), 3U);
  EXPECT_EQ(recognise(Json{{"features", {ed269_zone()}}}.dump(), zone_formats()), nullptr);
  EXPECT_EQ(recognise(collection(ed318_feature()).dump(), zone_formats()), nullptr);
}

}  // namespace
}  // namespace geom
