#include "traj/mission/airspace/volume_around.h"

#include <gtest/gtest.h>

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

Vec2 middle_of(const AirspacePrism& prism) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : prism.outline) sum += p;
  return sum / static_cast<double>(prism.outline.size());
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
    Vec2& corner = wider.outline[seed % wider.outline.size()];
    corner += 2 * (corner - middle_of(prism)).normalized();
    EXPECT_FALSE(holds_prism(volume, wider, kOrigin, "f")) << seed;
  }
}

}  // namespace
}  // namespace traj
