#include "geom/text/geojson_crs.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace geom {
namespace {

template <class Json>
bool foreign(const std::string& crs) {
  return has_foreign_crs(Json::parse(R"({"type":"Feature","crs":)" + crs + "}"));
}

TEST(GeoJsonCrs, IsForeignUnlessItIsWgs84) {
  EXPECT_FALSE(has_foreign_crs(nlohmann::json::parse(R"({"type":"Feature"})")));
  EXPECT_FALSE(has_foreign_crs(nlohmann::json::parse("[1]")));
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84",
                           "urn:ogc:def:crs:OGC::CRS84h"}) {
    const std::string crs =
        R"({"type":"name","properties":{"name":")" + std::string(name) + R"("}})";
    EXPECT_FALSE(foreign<nlohmann::json>(crs)) << name;
    EXPECT_FALSE(foreign<nlohmann::ordered_json>(crs)) << name;
  }
  for (const char* crs :
       {"null", "{}", "4326", R"({"type":"name","properties":{"name":"EPSG:3857"}})",
        R"({"type":"link","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}})",
        R"({"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::4326"}})"}) {
    EXPECT_TRUE(foreign<nlohmann::json>(crs)) << crs;
    EXPECT_TRUE(foreign<nlohmann::ordered_json>(crs)) << crs;
  }
}

}  // namespace
}  // namespace geom
