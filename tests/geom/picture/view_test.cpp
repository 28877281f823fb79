// Views: pixels and rays, and what an overview shows.

#include "geom/picture/view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace {

using geom::Aabb;
using geom::Vec3;
using geom::picture::Rays;
using geom::picture::View;
using support::Random;

TEST(ViewProperty, ProjectionUndoesTheRay) {
  Random random(26);
  for (int i = 0; i < 200; ++i) {
    View view = geom::picture::overview({{-50, -80, 0}, {70, 90, 40}}, 400, 300, {});
    if (i % 2) view = geom::picture::plan_view({{-50, -80, 0}, {70, 90, 40}}, 400, 300);
    const double u = random.uniform(0, 400);
    const double v = random.uniform(0, 300);
    const double depth = random.uniform(1, 500);
    const auto ray = Rays(view).through(u, v);
    const Vec3 back = geom::picture::project(view, ray.origin + depth * ray.direction);
    EXPECT_NEAR((back - Vec3(u, v, depth)).norm(), 0, 1e-7) << "seed 26, case " << i;
  }
}

TEST(ViewProperty, AnOverviewHoldsAllOfTheRegionAndFillsThePicture) {
  Random random(27);
  for (int i = 0; i < 200; ++i) {
    const Aabb region{{0, 0, 0},
                      {random.uniform(1, 900), random.uniform(1, 900), random.uniform(1, 200)}};
    const View view = geom::picture::overview(
        region, 640, 480, {random.uniform(-3, 3), random.uniform(0.1, 1.5), 0.7});
    double least = 1e9;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner(k & 1 ? region.max.x() : 0, k & 2 ? region.max.y() : 0,
                        k & 4 ? region.max.z() : 0);
      const Vec3 at = geom::picture::project(view, corner);
      EXPECT_GT(at.z(), 0) << "seed 27, case " << i;
      const double room = std::min({at.x(), 639 - at.x(), at.y(), 479 - at.y()});
      EXPECT_GT(room, 0) << "seed 27, case " << i;
      least = std::min(least, room);
    }
    EXPECT_LT(least, 60) << "seed 27, case " << i;
  }
}

}  // namespace
