#include "traj/flight/tilted_radius.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

TEST(TiltedRadius, HoldsTheBodyAtEveryTiltUpToTheOneThatIsFlown) {
  testing::Random random(4);
  for (int k = 0; k < 200; ++k) {
    const geom::Vec3 body(random.number(0, 1), random.number(0, 1), random.number(0, 1));
    geom::Vehicle vehicle{"quad", geom::attitude_half_sizes(body, 0.3)};
    vehicle.limits[geom::Limit::tilt] = 0.3;
    const double tilt = random.number(0, 2);
    const std::vector<double> radius{0.1, 0.2};
    const auto out = tilted_radius(radius, tilt, vehicle, body);
    ASSERT_EQ(out.size(), 2u);
    if (tilt <= 0.3) {
      EXPECT_EQ(out, radius);
      continue;
    }
    const geom::Vec3 needs = geom::attitude_half_sizes(body, std::min(tilt, 1.5707963267948966));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(vehicle.half[axis] + out[0] + 1e-12, needs[axis] + radius[0]);
    }
  }
}

TEST(TiltedRadius, IsTheRadiusWhereNoBodyIsKnown) {
  geom::Vehicle vehicle{"box", {1, 1, 1}};
  EXPECT_TRUE(holds_at_tilt(vehicle, 3)) << "without a limit half sizes hold at every tilt";
  vehicle.limits[geom::Limit::tilt] = 0.3;
  EXPECT_FALSE(holds_at_tilt(vehicle, 0.4));
  EXPECT_EQ(tilted_radius({{0.1}}, 1, vehicle, {}), std::vector{0.1});
}

}  // namespace
}  // namespace traj
