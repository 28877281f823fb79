#include "roadmap/point_index.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace plan {
namespace {

// Whole metres among the coordinates, so that points coincide and distances tie.
geom::Vec3 random_point(support::Random& random, double side) {
  geom::Vec3 p;
  for (int k = 0; k < 3; ++k) {
    p[k] = random.below(3) ? random.stepped(0, side, 1) : random.uniform(0, side);
  }
  return p;
}

TEST(PointIndex, AnswersAsLookingAtEveryPointDoes) {
  for (const double side : {2.0, 20.0}) {
    support::Random random(static_cast<std::uint64_t>(side));
    PointIndex index;
    std::vector<geom::Vec3> points;
    for (std::uint32_t id = 0; id < 700; ++id) {
      points.push_back(random_point(random, side));
      index.insert(points.back(), id);
      const geom::Vec3 p = random_point(random, side);
      const double radius = random.stepped(0, side / 2, 0.5);
      std::uint32_t nearest = 0;
      std::vector<std::uint32_t> within;
      for (std::uint32_t i = 0; i <= id; ++i) {
        const double squared = (p - points[i]).squaredNorm();
        if (squared < (p - points[nearest]).squaredNorm()) nearest = i;
        if (squared <= radius * radius) within.push_back(i);
      }
      ASSERT_EQ(index.nearest(p), nearest) << "side " << side << " of " << id + 1;
      ASSERT_EQ(index.within(p, radius), within) << "side " << side << " of " << id + 1;
    }
  }
}

}  // namespace
}  // namespace plan
