#include "geom/import/volume_keep_out.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>

#include "support/reading.h"

namespace geom {
namespace {

const Frame kFrame{Axes::enu, GeodeticOrigin{48.2, 16.37, 203}, ""};

Volume4d triangle() {
  Volume4d volume;
  volume.outline.ring = {{48.2, 16.4, 0}, {48.2, 16.42, 0}, {48.22, 16.4, 0}};
  return volume;
}

KeepOut placed(const Volume4d& volume, const Frame& frame = kFrame,
               const VolumeKeepOutOptions& options = {{}, -5, 120}) {
  return keep_out_of(std::vector{volume}, "v.json", frame, options);
}

TEST(VolumeKeepOut, StandsAtItsAltitudes) {
  Volume4d volume = triangle();
  EXPECT_EQ(placed(volume).volumes[0].bottom, -5);
  EXPECT_EQ(placed(volume).volumes[0].top, 120);
  volume.lower = 213.1;
  volume.upper = 250.2;
  EXPECT_LE(placed(volume).volumes[0].bottom, 213.1 - 203);
  EXPECT_GE(placed(volume).volumes[0].top, 250.2 - 203);
  EXPECT_NEAR(placed(volume).volumes[0].bottom, 10.1, 1e-12);
  EXPECT_NEAR(placed(volume).volumes[0].top, 47.2, 1e-12);
  EXPECT_FALSE(placed(volume).open_below || placed(volume).open_above);
  volume.lower.reset();
  EXPECT_TRUE(placed(volume).open_below && !placed(volume).open_above);
  volume.upper = 100;  // below the map
  EXPECT_EQ(placed(volume).volumes[0].bottom, -103);
  EXPECT_EQ(placed(volume, kFrame, {50, -5, 120}).volumes[0].top, 50);
}

TEST(VolumeKeepOut, HoldsItsEdges) {
  const Volume4d volume = triangle();
  Frame neu = kFrame;
  neu.axes = Axes::neu;
  for (const Frame& frame : {kFrame, neu}) {
    const KeepOut out = placed(volume, frame);
    EXPECT_LT(out.bulge[0], 1);
    for (std::size_t i = 0; i < 3; ++i) {
      const GeodeticPlace& a = volume.outline.ring[i];
      const GeodeticPlace& b = volume.outline.ring[(i + 1) % 3];
      const auto line = GeographicLib::Geodesic::WGS84().InverseLine(a.latitude, a.longitude,
                                                                     b.latitude, b.longitude);
      for (double at = 0; at <= 1; at += 1e-3) {
        GeodeticPlace p{0, 0, 203};
        line.Position(at * line.Distance(), p.latitude, p.longitude);
        const Vec3 there = to_enu(frame.axes, GeographicFrame(*kFrame.origin).enu(p));
        ASSERT_LE(distance(out.volumes[0].polygon, there.head<2>()), out.bulge[0]);
      }
    }
  }
}

TEST(VolumeKeepOut, RefusesWhatCannotBeKnown) {
  Volume4d volume = triangle();
  const auto refusal = [&](const Frame& frame) {
    return support::refusal_of([&] { placed(volume, frame); });
  };
  EXPECT_EQ(refusal({}),
            "v.json: the map has no origin on Earth, so latitudes and longitudes have no place on "
            "it");
  Frame flat = kFrame;
  flat.origin->height = 0;
  EXPECT_EQ(refusal(flat), "");  // no altitude: from the bottom of the map to its top
  volume.upper = 250;
  EXPECT_EQ(refusal(flat),
            "v.json: altitudes of ASTM F3548 are above the ellipsoid, and the map does not say how "
            "high above it its z = 0 is (0 m, as maps have whose height nobody gave): say that "
            "height");
  EXPECT_EQ(placed(volume, flat, {0, -5, 120}).volumes[0].top, 250);
  volume.outline.ring[1].longitude = 18;
  EXPECT_EQ(refusal(kFrame),
            "v.json: volume 0: expected edges of at most 100 km, found one of 119 km: give it more "
            "vertices");
}

}  // namespace
}  // namespace geom
