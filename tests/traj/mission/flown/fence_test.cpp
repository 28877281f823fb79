#include "traj/mission/flown/fence.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

const geom::GeodeticOrigin kOrigin{47, 8, 400};

GeodeticFence ring(std::vector<geom::GeodeticPlace> places) {
  return {true, std::move(places), {}, 0};
}

std::string refusal(const GeodeticFence& fence) {
  return support::refusal_of([&] { fence_on_map(fence, kOrigin, "f"); });
}

TEST(FenceOnMap, HoldsACircleOnTheSafeSide) {
  const geom::GeodeticPlace centre{47, 8, 0};
  for (const bool inclusion : {true, false}) {
    const Fence fence = fence_on_map({inclusion, {}, centre, 100}, kOrigin, "f");
    ASSERT_EQ(fence.ring.size(), 256u);
    const geom::Polygon polygon{fence.ring, {}};
    for (double angle = 0; angle < 6.3; angle += 0.003) {
      const geom::Vec2 out(std::cos(angle), std::sin(angle));
      EXPECT_EQ(geom::contains(polygon, 99.99 * out), true);
      EXPECT_EQ(geom::contains(polygon, (inclusion ? 100.0000001 : 100.01) * out), false);
      if (!inclusion) {
        EXPECT_TRUE(geom::contains(polygon, 100 * out));
      }
    }
  }
}

// A map's metres east of its origin are longer than the Earth's.
TEST(FenceOnMap, SaysHowFarACircleIsStretched) {
  const geom::GeodeticPlace centre{47, 9.2, 0};
  const Fence fence = fence_on_map({true, {}, centre, 1000}, kOrigin, "f");
  const geom::GeographicFrame map(kOrigin);
  const geom::GeographicFrame there({47, 9.2, 400});
  double least = 1e9;
  double most = 0;
  geom::Vec2 middle;
  map.from_geodetic(47, 9.2, middle.x(), middle.y());
  for (double angle = 0; angle < 6.3; angle += 0.05) {
    const auto place = there.place({1000 * std::cos(angle), 1000 * std::sin(angle), 0});
    geom::Vec2 p;
    map.from_geodetic(place.latitude, place.longitude, p.x(), p.y());
    least = std::min(least, (p - middle).norm());
    most = std::max(most, (p - middle).norm());
  }
  EXPECT_GT(most, 1000.05);
  EXPECT_GT(least, 1000 - fence.bulge);
  EXPECT_LT(most, 1000 + fence.bulge);
  EXPECT_LT(fence.bulge, 0.2);
}

TEST(FenceOnMap, SaysHowFarEdgesMayBend) {
  // A square of a degree: an edge along the parallel 48 bends by 300 m and more.
  const Fence large =
      fence_on_map(ring({{47, 8, 0}, {47, 9, 0}, {48, 9, 0}, {48, 8, 0}}), kOrigin, "f");
  const geom::GeographicFrame earth(kOrigin);
  geom::Vec2 middle;
  earth.from_geodetic(48, 8.5, middle.x(), middle.y());
  const double bent = geom::distance({{large.ring[2], large.ring[3]}, {}}, middle);
  EXPECT_GT(bent, 100);
  EXPECT_GT(large.bulge, bent);
  EXPECT_LT(large.bulge, 10 * bent);
  EXPECT_LT(fence_on_map(ring({{47, 8, 0}, {47, 8.002, 0}, {47.001, 8, 0}}), kOrigin, "f").bulge,
            0.02);
}

TEST(FenceOnMap, RefusesWhatIsNoFence) {
  EXPECT_EQ(
      refusal(ring({{47, 8, 0}, {47.1, 8, 0}})),
      "f: a fence must be a ring of three places or more whose edges do not cross, found 2 places");
  EXPECT_EQ(refusal(ring({{47, 8, 0}, {47.1, 8.1, 0}, {47.1, 8, 0}, {47, 8.1, 0}})),
            "f: a fence must be a ring of three places or more whose edges do not cross, found 4 "
            "places and edges that cross");
  EXPECT_EQ(refusal({true, {}, {47, 8, 0}, 0}),
            "f: the radius of a fence must be above 0 and within 1e5 m, found 0");
  EXPECT_EQ(refusal({true, {}, {12, 8, 0}, 5}),
            "f: expected a fence near the origin 47 8, found 12 8");
}

}  // namespace
}  // namespace traj
