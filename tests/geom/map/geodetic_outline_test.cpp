#include "geom/map/geodetic_outline.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include "support/reading.h"

namespace geom {
namespace {

const GeodeticOrigin kOrigin{48.2, 16.37, 200};

Vec2 on_map(double latitude, double longitude) {
  Vec2 p;
  GeographicFrame(kOrigin).from_geodetic(latitude, longitude, p.x(), p.y());
  return p;
}

// From p to the ring itself, inside too.
double from_ring(const std::vector<Vec2>& ring, const Vec2& p) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 way = ring[(i + 1) % ring.size()] - a;
    const double at = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + at * way - p).norm());
  }
  return least;
}

MapOutline placed(const GeodeticOutline& outline, CircleSide side = CircleSide::around) {
  return outline_on_map(outline, kOrigin, side, "an area", "f");
}

TEST(OutlineOnMap, HoldsACircleOfTheEllipsoid) {
  const auto& earth = GeographicLib::Geodesic::WGS84();
  for (const double longitude : {16.37, 16.4, 18.5}) {
    for (const double radius : {0.5, 30.0, 5000.0, 1e5}) {
      const GeodeticOutline circle{{}, {48.1, longitude, 0}, radius};
      const MapOutline out = placed(circle);
      const MapOutline in = placed(circle, CircleSide::within);
      for (double azimuth = 0; azimuth < 360; azimuth += 0.7) {
        double latitude;
        double there;
        earth.Direct(48.1, longitude, azimuth, radius, latitude, there);
        const Vec2 p = on_map(latitude, there);
        ASSERT_LE(distance({out.ring, {}}, p), out.bulge + 1e-7) << radius << ' ' << azimuth;
        if (contains({in.ring, {}}, p)) {
          ASSERT_LE(from_ring(in.ring, p), in.bulge + 1e-7);
        }
      }
      EXPECT_LT(out.bulge, 1e-3 * radius);
    }
  }
}

TEST(OutlineOnMap, SaysHowFarEdgesMayBend) {
  const auto& earth = GeographicLib::Geodesic::WGS84();
  for (const double size : {0.001, 0.02, 0.5}) {
    const GeodeticOutline square{{{48.2, 16.4, 0},
                                  {48.2, 16.4 + size, 0},
                                  {48.2 + size, 16.4 + size, 0},
                                  {48.2 + size, 16.4, 0}},
                                 {},
                                 0};
    const MapOutline out = placed(square);
    double furthest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const GeodeticPlace& a = square.ring[i];
      const GeodeticPlace& b = square.ring[(i + 1) % 4];
      const auto line = earth.InverseLine(a.latitude, a.longitude, b.latitude, b.longitude);
      for (double at = 0; at <= 1; at += 0.01) {
        double latitude;
        double longitude;
        line.Position(at * line.Distance(), latitude, longitude);
        furthest = std::max(furthest, from_ring(out.ring, on_map(latitude, longitude)));
        const Vec2 straight = on_map(a.latitude + at * (b.latitude - a.latitude),
                                     a.longitude + at * (b.longitude - a.longitude));
        furthest = std::max(furthest, from_ring(out.ring, straight));
      }
    }
    EXPECT_LE(furthest, out.bulge);
    EXPECT_GT(5 * furthest, out.bulge);
  }
}

TEST(OutlineOnMap, RefusesWhatHasNoAreaThere) {
  const auto refusal = [](const GeodeticOutline& outline) {
    return support::refusal_of([&] { placed(outline); });
  };
  EXPECT_EQ(refusal({{{48.2, 16.4, 0}, {48.3, 16.4, 0}}, {}, 0}),
            "f: an area must be a ring of three places or more whose edges do not cross, found 2 "
            "places");
  EXPECT_EQ(refusal({{}, {48.2, 16.4, 0}, std::nan("")}),
            "f: the radius of an area must be above 0 and within 1e5 m, found nan");
  EXPECT_EQ(refusal({{}, {48.2, 66.4, 0}, 5}),
            "f: expected an area near the origin 48.2 16.37, found 48.2 66.4");
}

}  // namespace
}  // namespace geom
