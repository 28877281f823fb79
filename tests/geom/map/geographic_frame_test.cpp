#include "geom/map/geographic_frame.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(GeographicFrame, CountsFromItsOrigin) {
  const GeographicFrame frame({60, 25, 12.5});
  EXPECT_LT(frame.enu({60, 25, 12.5}).norm(), 1e-9);
  EXPECT_NEAR(frame.enu({60, 25, 20}).z(), 7.5, 1e-12) << "heights add up";
  const GeodeticPlace place = frame.place({0, 0, 3});
  EXPECT_NEAR(place.latitude, 60, 1e-13);
  EXPECT_NEAR(place.longitude, 25, 1e-13);
  EXPECT_EQ(place.height, 15.5);
}

// The arc of a meridian from the equator to 1 degree, and of the equator over a hundredth, on
// WGS 84 (a = 6378137 m: a pi / 180 / 100 = 1113.1949 m).
TEST(GeographicFrame, MeasuresInMetresEastAndNorth) {
  const GeographicFrame frame({0, 8, 0});
  const Vec3 north = frame.enu({1, 8, 0});
  EXPECT_NEAR(north.x(), 0, 1e-9);
  EXPECT_NEAR(north.y(), 110574.3886, 1e-3);
  const Vec3 east = frame.enu({0, 8.01, 0});
  EXPECT_NEAR(east.x(), 1113.1949, 1e-3);
  EXPECT_NEAR(east.y(), 0, 1e-9);
}

TEST(GeographicFrame, ComesBackToNanometresWithinAThousandKilometres) {
  support::Random random(1);
  for (int i = 0; i < 300; ++i) {
    const GeographicFrame frame({random.uniform(-75, 75), random.uniform(-180, 180), 100});
    const Vec3 p(random.uniform(-7e5, 7e5), random.uniform(-7e5, 7e5), random.uniform(-9, 900));
    ASSERT_LT((frame.enu(frame.place(p)) - p).norm(), 1e-8) << "seed 1, case " << i;
    double east, north;
    const GeodeticPlace there = frame.place(p);
    frame.from_geodetic(there.latitude, there.longitude, east, north);
    ASSERT_NEAR(east, p.x(), 1e-8) << "seed 1, case " << i;
    ASSERT_NEAR(north, p.y(), 1e-8) << "seed 1, case " << i;
  }
}

TEST(CountsFromOrigin, NeedsAnOriginAndNoCrsOfAnotherKind) {
  const GeodeticOrigin origin{60, 25, 0};
  EXPECT_TRUE(counts_from_origin({Axes::enu, origin, ""}));
  EXPECT_FALSE(counts_from_origin({Axes::enu, {}, ""}));
  EXPECT_FALSE(counts_from_origin({Axes::enu, origin, "EPSG:3879"}));
  EXPECT_TRUE(counts_from_origin({Axes::enu, origin, "+proj=tmerc +lat_0=60 +lon_0=25"}));
}

}  // namespace
}  // namespace geom
