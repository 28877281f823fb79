#include "geom/cloud/proj_reference.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"

namespace {

using geom::ProjReference;
using Kind = geom::CoordinateReference::Kind;

TEST(ProjReference, KnowsUnitsOfThePlaneAndOfHeights) {
  const auto feet = ProjReference::of("EPSG:2994+6360");
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->told().kind, Kind::metric);
  EXPECT_DOUBLE_EQ(*feet->told().plane, 0.3048);
  EXPECT_DOUBLE_EQ(*feet->told().up, 1200.0 / 3937);
  EXPECT_FALSE(ProjReference::of("EPSG:25832")->told().up);
  EXPECT_EQ(ProjReference::of("EPSG:4326")->told().kind, Kind::no_plane);
  EXPECT_EQ(ProjReference::of("EPSG:3857")->told().kind, Kind::no_plane);
  EXPECT_EQ(ProjReference::of("EPSG:4978")->told().kind, Kind::no_plane);
  EXPECT_TRUE(ProjReference::of("EPSG:3857")->places());
  EXPECT_FALSE(ProjReference::of("EPSG:4978")->places());
}

TEST(ProjReference, KnowsDepths) {
  EXPECT_TRUE(ProjReference::of("EPSG:32632+5715")->told().depths);
  EXPECT_FALSE(ProjReference::of("EPSG:32632+5714")->told().depths);
  EXPECT_FALSE(ProjReference::of("EPSG:25832")->told().depths);
}

TEST(ProjReference, IsNothingOfOtherText) {
  for (const char* text : {"", "Oregon", "EPSG:1", "PROJCS[\"a\"", "GeoTIFF keys: user-defined"}) {
    EXPECT_FALSE(ProjReference::of(text)) << text;
  }
}

// Transverse Mercator about the origin is what the maps mean by metres from it.
TEST(ProjWay, LeadsToMetresAboutThePlace) {
  const geom::GeodeticOrigin origin{48.2, 16.37, 0};
  const auto degrees = ProjReference::of("EPSG:4326");
  const geom::ProjWay way = geom::way_to_plane(*degrees, origin, "t");
  const geom::GeographicFrame frame(origin);
  for (const auto& [longitude, latitude] :
       {std::pair{16.37, 48.2}, {16.5, 48.1}, {16.0, 48.5}, {17.5, 47.9}}) {
    geom::CloudPoint p{{longitude, latitude, 7}};
    way.project({&p, 1});
    geom::Vec3 expected(0, 0, 7);
    frame.from_geodetic(latitude, longitude, expected.x(), expected.y());
    EXPECT_LT((p.position - expected).norm(), 1e-6);
  }
}

// The datum of Britain is some 125 m away from that of WGS 84 at London.
TEST(ProjWay, NeverTakesOneDatumForAnother) {
  const auto britain = ProjReference::of("EPSG:27700");
  const geom::ProjWay way = geom::way_to_plane(*britain, {51.5, -0.12, 0}, "t");
  geom::CloudPoint p{{530000, 180000, 0}};
  way.project({&p, 1});
  EXPECT_NEAR(p.position.x(), -580.05, 10);  // by whichever grid or shift is installed
  EXPECT_NEAR(p.position.y(), 444.04, 10);
  const auto unknown = ProjReference::of("+proj=tmerc +lat_0=51 +lon_0=0 +ellps=airy +units=m");
  ASSERT_TRUE(unknown);
  EXPECT_THROW(geom::way_to_plane(*unknown, {51.5, -0.12, 0}, "t"), geom::InputError);
}

TEST(ProjWay, RefusesPointsThatAreNowhere) {
  const auto utm = ProjReference::of("EPSG:32633");
  const geom::ProjWay way = geom::way_to_plane(*utm, {48, 15, 0}, "t");
  geom::CloudPoint p{{1e300, 0, 0}};
  EXPECT_THROW(way.project({&p, 1}), geom::InputError);
  EXPECT_THROW(geom::way_to_plane(*ProjReference::of("EPSG:4978"), {48, 15, 0}, "t"),
               geom::InputError);
}

TEST(ProjWay, KnowsWhatComesToLieInARectangle) {
  const auto utm = ProjReference::of("EPSG:32633");
  const geom::ProjWay way = geom::way_to_plane(*utm, {48.2, 16.37, 0}, "t");
  const geom::Aabb region{{-2000, -1000, 0}, {3000, 4000, 0}};
  const auto origin = way.origin_of(region);
  ASSERT_TRUE(origin);
  std::vector<geom::CloudPoint> points;
  for (int i = 0; i <= 200; ++i) {
    for (int k = 0; k <= 200; ++k) {
      points.push_back({{origin->min.x() - 500 + i * 40, origin->min.y() - 500 + k * 40, 0}});
    }
  }
  std::vector<geom::CloudPoint> there = points;
  way.project(there);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!contains(region, there[i].position)) continue;
    geom::Vec3 p = points[i].position;
    p.z() = origin->min.z();
    EXPECT_TRUE(contains(*origin, p));
  }
}

TEST(OriginNear, IsATidyPlaceAtThePoint) {
  const auto origin =
      geom::origin_near(*ProjReference::of("EPSG:32633"), {500000, 5400000, 9}, "t");
  EXPECT_DOUBLE_EQ(origin.latitude, 48.753);
  EXPECT_DOUBLE_EQ(origin.longitude, 15);
  EXPECT_EQ(origin.height, 0);
}

}  // namespace
