#include "geom/earth/proj_way.h"

#include <gtest/gtest.h>

#include <vector>

#include "geom/map/geographic_frame.h"

namespace {

using geom::GeodeticOrigin;
using geom::ProjReference;
using geom::ProjWay;
using geom::Vec2;

std::optional<ProjWay> to_plane(const std::string& system, const GeodeticOrigin& origin) {
  return ProjWay::to_plane(*ProjReference::of(system), origin);
}

std::optional<Vec2> place(const std::string& system, const Vec2& point) {
  const auto way = ProjWay::to_places(*ProjReference::of(system));
  return way ? way->place_of(point) : std::nullopt;
}

// Transverse Mercator about the origin is what the maps mean by metres from it.
TEST(ProjWay, LeadsToMetresAboutThePlace) {
  const GeodeticOrigin origin{48.2, 16.37, 0};
  const auto way = to_plane("EPSG:4326", origin);
  const geom::GeographicFrame frame(origin);
  for (const auto& [longitude, latitude] :
       {std::pair{16.37, 48.2}, {16.5, 48.1}, {16.0, 48.5}, {17.5, 47.9}}) {
    Vec2 p(longitude, latitude);
    way->forward({&p, 1});
    Vec2 expected;
    frame.from_geodetic(latitude, longitude, expected.x(), expected.y());
    EXPECT_LT((p - expected).norm(), 1e-6);
    way->back({&p, 1});
    EXPECT_LT((p - Vec2(longitude, latitude)).norm(), 1e-12);
  }
}

// As the plane's own PROJ string means it.
TEST(ProjWay, LeadsBackFromThePlaneOfMaps) {
  const GeodeticOrigin origin{52, 4.37, 0};
  Vec2 p(85000, 447000);
  to_plane("EPSG:28992", origin)->forward({&p, 1});
  const auto of_plane = place(geom::plane_about(origin), p);
  const auto of_source = place("EPSG:28992", {85000, 447000});
  EXPECT_LT((*of_plane - *of_source).norm(), 1e-13);
}

// Axes of all kinds. The places are those of GDAL 3.6, with x first (OAMS_TRADITIONAL_GIS_ORDER).
TEST(ProjWay, HasXBeforeYInEverySystem) {
  const auto expect = [](const char* system, const Vec2& point, const Vec2& there) {
    const auto found = place(system, point);
    ASSERT_TRUE(found) << system;
    EXPECT_LT((*found - there).norm(), 1e-4) << system << ": " << found->transpose();
  };
  expect("EPSG:4326", {13.4, 52.5}, {13.4, 52.5});
  expect("OGC:CRS84", {13.4, 52.5}, {13.4, 52.5});
  expect("EPSG:4807", {0, 54}, {2.336509, 48.599932});  // grads from Paris
  expect("EPSG:3035", {4321000, 3210000}, {10, 52});
  expect("EPSG:2180", {500000, 486700}, {19, 52.246338});
  expect("EPSG:32661", {2000000, 0}, {0, 72.126361});
  expect("EPSG:5041", {2000000, 0}, {0, 72.126361});
  expect("EPSG:3031", {0, 1e6}, {0, -80.815265});
  expect("EPSG:2046", {0, 3e6}, {15, -27.111636});  // westing and southing
}

// The datum of Britain is some 125 m away from that of WGS 84 at London.
TEST(ProjWay, NeverTakesOneDatumForAnother) {
  Vec2 p(530000, 180000);
  to_plane("EPSG:27700", {51.5, -0.12, 0})->forward({&p, 1});
  EXPECT_NEAR(p.x(), -580.05, 10);  // by whichever grid or shift is installed
  EXPECT_NEAR(p.y(), 444.04, 10);
  const std::string airy = "+proj=tmerc +lat_0=51 +lon_0=0 +ellps=airy +units=m";
  EXPECT_FALSE(to_plane(airy, {51.5, -0.12, 0}));
  EXPECT_TRUE(to_plane(airy + " +towgs84=446,-125,542", {51.5, -0.12, 0}));
}

TEST(ProjWay, IsNoneFromSystemsWithoutPlaces) {
  for (const char* system : {"EPSG:4978", "EPSG:5773", R"(LOCAL_CS["site",UNIT["metre",1]])"}) {
    EXPECT_FALSE(ProjWay::to_places(*ProjReference::of(system))) << system;
  }
}

// Heights do not pass through the way, so that theirs need not be known.
TEST(ProjWay, DoesNotLookAtHeights) {
  EXPECT_EQ(*place("EPSG:7415", {85000, 447000}), *place("EPSG:28992", {85000, 447000}));
}

TEST(ProjWay, ConvertsEachPointAsIfItWereAlone) {
  const auto way = to_plane("EPSG:28992", {52, 4.37, 0});
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(84000 + 7 * i, 447000 + i);
  std::vector<Vec2> together = points;
  way->forward(together);
  for (std::size_t i = 0; i < points.size(); ++i) {
    way->forward({&points[i], 1});
    EXPECT_EQ(points[i], together[i]);
  }
}

// Old datums have several transformations, and the areas of these meet within the rectangles.
TEST(ProjWay, TheWayBackIsTheWayThereOrNone) {
  int none = 0;
  int same = 0;
  for (const char* system : {"EPSG:4267", "EPSG:4408", "EPSG:4230"}) {
    for (const auto& [latitude, longitude] :
         {std::pair(49.0, -95.0), {60.0, -120.0}, {42.0, -141.0}, {47.0, 2.0}, {62.0, 5.0}}) {
      const auto way = to_plane(system, {latitude, longitude, 0});
      if (!way) continue;
      std::vector<Vec2> points;
      for (int i = -60; i <= 60; ++i) {
        for (int k = -60; k <= 60; ++k) points.emplace_back(i * 5000.0 + 1, k * 5000.0 + 1);
      }
      std::vector<Vec2> there = points;
      way->back(there);
      std::vector<Vec2> again = there;
      way->forward(again);
      for (std::size_t n = 0; n < points.size(); ++n) {
        none += !there[n].allFinite();
        if (!there[n].allFinite()) continue;
        ++same;
        EXPECT_LT((again[n] - points[n]).norm(), 0.011) << system;
      }
    }
  }
  EXPECT_GT(none, 0);
  EXPECT_GT(same, 1000);
}

TEST(ProjWay, PointsThatAreNowhereBecomeInfinite) {
  const auto way = to_plane("EPSG:32633", {48, 15, 0});
  std::vector<Vec2> points{{500000, 5300000}, {1e300, 0}, {500000, 5300000}};
  way->forward(points);
  EXPECT_FALSE(points[1].allFinite());
  EXPECT_EQ(points[0], points[2]);
  EXPECT_FALSE(place("EPSG:32633", {1e300, 0}));
}

TEST(ProjWay, KnowsWhatComesToLieInARectangle) {
  const auto way = to_plane("EPSG:32633", {48.2, 16.37, 0});
  const geom::Aabb region{{-2000, -1000, 0}, {3000, 4000, 0}};
  const auto origin = way->origin_of(region);
  ASSERT_TRUE(origin);
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) {
    for (int k = 0; k <= 200; ++k) {
      points.push_back({origin->min.x() - 500 + i * 40, origin->min.y() - 500 + k * 40});
    }
  }
  std::vector<Vec2> there = points;
  way->forward(there);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!contains(region, geom::Vec3(there[i].x(), there[i].y(), 0))) continue;
    EXPECT_TRUE(contains(*origin, geom::Vec3(points[i].x(), points[i].y(), origin->min.z())));
  }
}

TEST(ProjWay, KnowsNoRectangleOfDegreesAroundAPoleOrAcrossTheDateLine) {
  const geom::Aabb region{{-1000, -1000, 0}, {1000, 1000, 0}};
  EXPECT_TRUE(to_plane("EPSG:4326", {89, 10, 0})->origin_of(region));
  EXPECT_FALSE(to_plane("EPSG:4326", {89.999, 10, 0})->origin_of(region));
  EXPECT_FALSE(to_plane("EPSG:4326", {10, 179.999, 0})->origin_of(region));
  EXPECT_TRUE(to_plane("EPSG:5041", {89.999, 10, 0})->origin_of(region));
}

TEST(TidyOrigin, IsATidyPlaceAtThePoint) {
  const GeodeticOrigin origin = geom::tidy_origin(*place("EPSG:32633", {500000, 5400000}), 1e3);
  EXPECT_DOUBLE_EQ(origin.latitude, 48.753);
  EXPECT_DOUBLE_EQ(origin.longitude, 15);
  EXPECT_EQ(origin.height, 0);
}

}  // namespace
