#include "geom/map/near_map.h"

#include <gtest/gtest.h>

#include "geom/map/geographic_frame.h"

namespace geom {
namespace {

BoxMapSpec spec_of(double side) { return {.bounds = {{0, 0, 0}, {side, side, 50}}}; }

std::vector<Vec2> square_at(double x, double y) {
  return {{x, y}, {x + 5, y}, {x + 5, y + 5}, {x, y + 5}};
}

TEST(WhyNotNear, SaysNothingOfWhatMeetsTheBoundsOrLiesWithinTenKilometres) {
  for (const double x : {-5.0, 50.0, 100.0, 10'099.0}) {
    EXPECT_FALSE(why_not_near(spec_of(100), {square_at(x, 50)})) << x;
  }
  const auto far = why_not_near(spec_of(100), {square_at(10'101, 50)});
  ASSERT_TRUE(far);
  EXPECT_NE(far->find("10 km from its bounds"), std::string::npos) << *far;
}

TEST(WhyNotNear, AllowsAsMuchAsTheBoundsAreLong) {
  const double diagonal = 40'000 * std::sqrt(2);
  EXPECT_FALSE(why_not_near(spec_of(40'000), {square_at(39'999 + diagonal, 0)}));
  EXPECT_TRUE(why_not_near(spec_of(40'000), {square_at(40'001 + diagonal, 0)}));
}

TEST(WhyNotNear, NamesLatitudeAndLongitudeThatWereExchanged) {
  for (const Axes axes : {Axes::enu, Axes::neu}) {
    BoxMapSpec spec = spec_of(1000);
    spec.frame.axes = axes;
    spec.frame.origin = GeodeticOrigin{60.17, 24.94, 0};
    const GeographicFrame earth(*spec.frame.origin);
    Vec3 there = Vec3::Zero();
    double latitude = 0;
    double longitude = 0;
    earth.to_geodetic(500, 500, latitude, longitude);
    earth.from_geodetic(longitude, latitude, there.x(), there.y());  // exchanged
    const Vec3 drawn = to_enu(axes, there);
    const std::vector<Vec2> ring = square_at(drawn.x(), drawn.y());
    const auto why = why_not_near(spec, {ring, true});
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("with latitude and longitude exchanged"), std::string::npos) << *why;
    const auto other = why_not_near(spec, {ring, false});  // a file that has the latitude first
    ASSERT_TRUE(other);
    EXPECT_EQ(other->find("exchange"), std::string::npos) << *other;
  }
}

}  // namespace
}  // namespace geom
