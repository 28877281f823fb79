#include "geom/map/box_geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_at(const std::optional<GeodeticOrigin>& origin, Axes axes) {
  BoxMapSpec spec;
  spec.bounds = {{-100, -100, 0}, {100, 100, 50}};
  spec.frame.origin = origin;
  spec.frame.axes = axes;
  return BoxMap(spec, support::table_of({{{10, 20, 1}, {12, 40, 12}}, {{-5, -6, 0}, {0, 0, 3}}}));
}

TEST(BoxGeojson, HasACounterClockwiseRingABoxInDegrees) {
  const GeodeticOrigin origin{60.17, 24.94, 3};
  const GeographicFrame earth(origin);
  for (const Axes axes : {Axes::enu, Axes::neu}) {
    const BoxMap map = map_at(origin, axes);
    std::ostringstream out;
    write_box_geojson(out, map, "m");
    const auto json = nlohmann::json::parse(out.str());
    ASSERT_EQ(json["type"], "FeatureCollection");
    ASSERT_EQ(json["features"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Aabb box = to_enu(axes, map.box(i));
      const auto& feature = json["features"][i];
      EXPECT_EQ(feature["properties"]["id"], map.ids()[i]);
      EXPECT_EQ(feature["properties"]["base"], box.min.z());
      EXPECT_EQ(feature["properties"]["height"], box.max.z() - box.min.z());
      const auto& ring = feature["geometry"]["coordinates"][0];
      ASSERT_EQ(ring.size(), 5u);
      EXPECT_EQ(ring[0], ring[4]);
      double doubled = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 p = earth.enu({ring[k][1], ring[k][0], origin.height});
        const Vec3 q = earth.enu({ring[k + 1][1], ring[k + 1][0], origin.height});
        doubled += p.x() * q.y() - q.x() * p.y();
        EXPECT_NEAR(p.x(), k == 1 || k == 2 ? box.max.x() : box.min.x(), 2e-4);
        EXPECT_NEAR(p.y(), k >= 2 ? box.max.y() : box.min.y(), 2e-4);
      }
      const Vec3 size = box.max - box.min;
      EXPECT_NEAR(doubled / 2, size.x() * size.y(), 0.01);
    }
  }
}

TEST(BoxGeojson, NeedsAPlaceOnEarth) {
  std::ostringstream out;
  EXPECT_THROW(write_box_geojson(out, map_at({}, Axes::enu), "m"), InputError);
  EXPECT_TRUE(out.str().empty());
}

}  // namespace
}  // namespace geom
