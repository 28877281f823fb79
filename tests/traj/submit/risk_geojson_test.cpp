#include "traj/submit/risk_geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"

namespace traj {
namespace {

const geom::GeodeticOrigin kOrigin{47.4, 8.5, 400};

geom::IntentVolumes intent() {
  geom::Volume4d zone = volume_around({{{0, 0}, {80, 0}, {80, 30}}, 10, 60}, kOrigin, "q1");
  zone.start = "2026-05-04T06:30:00Z";
  zone.end = "2026-05-04T06:40:00Z";
  return {{zone}, {}};
}

std::string text() {
  const RiskTask task{.rules = {.dimension = 0.7}, .speed = 10, .origin = kOrigin};
  return risk_geojson("q1", intent(), risk_volumes(intent(), task, "q1"));
}

TEST(RiskGeojson, ComesBackAsItWasWritten) {
  const ReadRisk read = read_risk_geojson(text(), "r");
  EXPECT_EQ(read.id, "q1");
  EXPECT_EQ(read.geography.size(), 1u);
  EXPECT_EQ(read.volumes.contingency.size(), 1u);
  EXPECT_EQ(read.volumes.buffers.size(), 1u);
  EXPECT_EQ(risk_geojson(read.id, intent(), read.volumes), text());
}

TEST(RiskGeojson, IsGeojsonOfRingsThatClose) {
  const nlohmann::json json = nlohmann::json::parse(text());
  EXPECT_EQ(json["type"], "FeatureCollection");
  ASSERT_EQ(json["features"].size(), 3u);
  for (const auto& feature : json["features"]) {
    const auto& ring = feature["geometry"]["coordinates"][0];
    EXPECT_EQ(ring.front(), ring.back());
    EXPECT_NEAR(ring[0][0].get<double>(), 8.5, 0.01) << "longitude first";
  }
}

// No value passes unread: a file with another one is refused, or is another file.
TEST(RiskGeojson, EveryMemberCounts) {
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(text());
  for (std::size_t i = 0; i < json["features"].size(); ++i) {
    for (const auto& [key, value] : json["features"][i]["properties"].items()) {
      nlohmann::ordered_json without = json;
      without["features"][i]["properties"].erase(key);
      EXPECT_THROW(read_risk_geojson(without.dump(), "r"), geom::InputError) << i << ' ' << key;
    }
  }
  for (const char* bad : {"", "{}", "[]", R"({"type":"FeatureCollection","features":[{}]})"}) {
    EXPECT_THROW(read_risk_geojson(bad, "r"), geom::InputError) << bad;
  }
}

}  // namespace
}  // namespace traj
