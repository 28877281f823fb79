#include "traj/mission/airspace/volume_around.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/shape/convex_outline.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::Vec2;

const geom::GeodeticOrigin kOrigin{60, 25, 10};

AirspacePrism random_prism(unsigned seed) {
  testing::Random random(seed);
  std::vector<Vec2> points;
  for (int i = 0; i < 7; ++i) points.push_back(random.vector(900).head<2>());
  return {geom::convex_outline(points), random.number(-5, 20), random.number(30, 200)};
}

TEST(VolumeAround, HoldsItsPrism) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const AirspacePrism prism = random_prism(seed);
    const geom::Volume4d volume = volume_around(prism, kOrigin, "f");
    EXPECT_TRUE(holds_prism(volume, prism, kOrigin, "f")) << seed;
    EXPECT_LE(*volume.upper - kOrigin.height - prism.high, 0.012);
    EXPECT_LE(prism.low + kOrigin.height - *volume.lower, 0.012);
  }
}

TEST(HoldsPrism, IsFalseOfALargerPrism) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const AirspacePrism prism = random_prism(seed);
    const geom::Volume4d volume = volume_around(prism, kOrigin, "f");
    AirspacePrism higher = prism;
    higher.high += 0.02;
    EXPECT_FALSE(holds_prism(volume, higher, kOrigin, "f"));
    AirspacePrism lower = prism;
    lower.low -= 0.02;
    EXPECT_FALSE(holds_prism(volume, lower, kOrigin, "f"));
    AirspacePrism wider = prism;
    wider.outline[seed % wider.outline.size()] *= 1.01;
    EXPECT_FALSE(holds_prism(volume, wider, kOrigin, "f")) << seed;
  }
}

}  // namespace
}  // namespace traj
