#include "geom/model/place_model.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>

#include "geom/map/geographic_frame.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

Vec3 earth_centred(const GeodeticPlace& p) {
  Vec3 v;
  GeographicLib::Geocentric::WGS84().Forward(p.latitude, p.longitude, p.height, v.x(), v.y(),
                                             v.z());
  return v;
}

Model triangle(const std::array<GeodeticPlace, 3>& places) {
  Model model;
  for (const GeodeticPlace& p : places) model.mesh.vertices.push_back(earth_centred(p));
  model.mesh.triangles.push_back({{0, 1, 2}, 0});
  return model;
}

TEST(PlaceOnMap, PutsVerticesWhereTheMapsFrameHasThem) {
  const GeodeticOrigin origin{48.2, 16.37, 150};
  const std::array<GeodeticPlace, 3> places = {
      GeodeticPlace{48.2, 16.37, 150}, {48.21, 16.4, 200}, {48.19, 16.3, -20}};
  Model model = triangle(places);
  const PlacedModel placed = place_on_map(model, origin, "a");
  EXPECT_EQ(placed.frame.origin, origin);
  const GeographicFrame frame(origin);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(model.mesh.vertices[i].isApprox(frame.enu(places[i]), 1e-9) ||
                (model.mesh.vertices[i] - frame.enu(places[i])).norm() < 1e-6);
  }
  EXPECT_LT(model.mesh.vertices[0].norm(), 1e-6);
}

TEST(PlaceOnMap, BeginsInTheMiddleAlsoAcrossTheDateLine) {
  Model model = triangle({GeodeticPlace{10, 179.9, 5}, {10.2, -179.9, 5}, {10.1, 180, 5}});
  const PlacedModel placed = place_on_map(model, std::nullopt, "a");
  EXPECT_NEAR(placed.frame.origin->latitude, 10.1, 1e-9);
  EXPECT_NEAR(std::abs(placed.frame.origin->longitude), 180, 1e-9);
  EXPECT_EQ(placed.frame.origin->height, 0);
}

// Points of the flat triangle in space, placed one by one, against those between placed corners.
TEST(PlaceOnMap, BendsNoTriangleByMoreThanItSays) {
  support::Random random(4);
  for (int round = 0; round < 50; ++round) {
    const double size = std::pow(10, random.uniform(-4, -0.3));  // degrees: 10 m to 50 km
    const GeodeticOrigin origin{random.uniform(-70, 70), random.uniform(-180, 180), 0};
    std::array<GeodeticPlace, 3> places;
    for (GeodeticPlace& p : places) {
      p = {origin.latitude + random.uniform(0, 1) + random.uniform(-size, size),
           origin.longitude + random.uniform(0, 0.7) + random.uniform(-size, size),
           random.uniform(0, 1e5 * size)};
    }
    Model model = triangle(places);
    const TriangleMesh before = model.mesh;
    const PlacedModel placed = place_on_map(model, origin, "a");
    for (int i = 0; i < 200; ++i) {
      const double a = random.uniform(0, 1);
      const double b = random.uniform(0, 1 - a);
      const auto mixed = [&](const TriangleMesh& mesh) {
        return Vec3((1 - a - b) * mesh.vertices[0] + a * mesh.vertices[1] + b * mesh.vertices[2]);
      };
      Model point;
      point.mesh.vertices = {mixed(before)};
      place_on_map(point, origin, "a");
      ASSERT_LE((point.mesh.vertices[0] - mixed(model.mesh)).norm(), placed.bend) << round;
    }
  }
}

TEST(PlaceOnMap, RefusesWhatIsNotNearTheGroundOrTheOrigin) {
  Model high = triangle({GeodeticPlace{10, 10, 0}, {10, 10.1, 0}, {10, 10, 2e5}});
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { place_on_map(high, std::nullopt, "a"); }), "100 km"));
  Model far = triangle({GeodeticPlace{10, 10, 0}, {10, 10.1, 0}, {10.1, 10, 0}});
  EXPECT_TRUE(support::says(support::refusal_of([&] {
                              place_on_map(far, GeodeticOrigin{14, 10, 0}, "a");
                            }),
                            "expected a model within 200 km of the origin"));
  Model none;
  EXPECT_NE(support::refusal_of([&] { place_on_map(none, std::nullopt, "a"); }), "");
}

}  // namespace
}  // namespace geom
