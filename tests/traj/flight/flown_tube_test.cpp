#include "traj/flight/flown_tube.h"

#include <gtest/gtest.h>

#include <vector>

#include "traj/scenes.h"

namespace traj {
namespace {

// 10 m to the east in 10 s, at even speed.
Trajectory straight() { return testing::straight({0, 0, 5}, {10, 0, 5}); }

TEST(FlownTube, MeasuresFromTheNearestPlace) {
  const std::vector<Vec3> points{{0, 0, 5}, {5, 0.3, 5}, {12, 0, 5}, {5, 0, 6}};
  const std::vector<double> times{0, 1, 2, 3};
  const FlownTube tube = flown_tube(straight(), {}, 1, points, times);
  EXPECT_NEAR(tube.furthest.value, 2, 1e-9);
  EXPECT_EQ(tube.furthest.time, 2);
  EXPECT_EQ(tube.inside, 0u);
}

TEST(FlownTube, CountsWhatIsWithin) {
  const std::vector<double> radius{0.1, 0.5};  // of the first 5 s, and of the rest
  const std::vector<Vec3> points{{1, 0.05, 5}, {2, 0.3, 5}, {8, 0.3, 5}, {8, 0.6, 5}, {10.4, 0, 5}};
  const std::vector<double> times{0, 1, 2, 3, 4};
  const FlownTube tube = flown_tube(straight(), radius, 5, points, times);
  EXPECT_EQ(tube.inside, 3u);
  EXPECT_EQ(tube.left, 1);
  EXPECT_NEAR(tube.furthest.value, 0.6, 1e-9);
}

TEST(FlownTube, AgreesWithAFineWalk) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Trajectory plan = testing::random_trajectory(seed);
    testing::Random random(seed + 100);
    const double end = duration(plan);
    std::vector<double> radius;
    for (double t = 0; t < end; t += 0.1) radius.push_back(random.number(0.5, 4));
    for (int k = 0; k < 20; ++k) {
      const Vec3 p = random.vector(12);
      double nearest = 1e9;
      double room = -1e9;  // how far within the tube
      for (int i = 0; i <= 4000; ++i) {
        const double t = end * i / 4000;
        const double d = (evaluate(plan, t).position - p).norm();
        nearest = std::min(nearest, d);
        const auto at = std::min(static_cast<std::size_t>(t / 0.1), radius.size() - 1);
        room = std::max(room, radius[at] - d);
      }
      const FlownTube tube = flown_tube(plan, radius, 0.1, {&p, 1}, std::vector<double>{0});
      EXPECT_NEAR(tube.furthest.value, nearest, 0.03) << "seed " << seed << " case " << k;
      // Surely within: never where the walk is not, and always where it is by 0.2 m.
      EXPECT_TRUE(tube.inside == 0 || room > -0.03) << "seed " << seed << " case " << k;
      EXPECT_TRUE(tube.inside == 1 || room <= 0.2) << "seed " << seed << " case " << k;
    }
  }
}

}  // namespace
}  // namespace traj
