#include "geom/shape/empty_box.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

// The largest volume by trying every box whose faces are those of the limits or of obstacles.
double brute_force(const Aabb& seed, const Aabb& limits, const std::vector<Aabb>& obstacles) {
  std::vector<double> low[3];
  std::vector<double> high[3];
  for (int i = 0; i < 3; ++i) {
    low[i].push_back(limits.min[i]);
    high[i].push_back(limits.max[i]);
    for (const Aabb& o : obstacles) {
      if (o.max[i] <= seed.min[i] && o.max[i] > limits.min[i]) low[i].push_back(o.max[i]);
      if (o.min[i] >= seed.max[i] && o.min[i] < limits.max[i]) high[i].push_back(o.min[i]);
    }
  }
  double best = -1;
  for (double x0 : low[0])
    for (double x1 : high[0])
      for (double y0 : low[1])
        for (double y1 : high[1])
          for (double z0 : low[2])
            for (double z1 : high[2]) {
              const Aabb box{{x0, y0, z0}, {x1, y1, z1}};
              const double volume = (box.max - box.min).prod();
              const bool empty =
                  std::none_of(obstacles.begin(), obstacles.end(), [&](const Aabb& o) {
                    return (o.min.array() < box.max.array()).all() &&
                           (o.max.array() > box.min.array()).all();
                  });
              if (empty) best = std::max(best, volume);
            }
  return best;
}

TEST(EmptyBox, IsTheLargestOfAll) {
  support::Random random(3);
  int tried = 0;
  while (tried < 60) {
    const Vec3 at(random.stepped(4, 12, 1), random.stepped(4, 12, 1), random.stepped(2, 6, 1));
    const Aabb seed{at, at + Vec3(random.stepped(0, 2, 1), random.stepped(0, 2, 1), 1)};
    const Aabb limits{Vec3::Zero(), {16, 16, 10}};
    std::vector<Aabb> obstacles;
    for (int i = 0; i < 7; ++i) {
      const Vec3 low(random.stepped(-2, 15, 1), random.stepped(-2, 15, 1), random.stepped(0, 9, 1));
      const Vec3 size(random.stepped(0, 5, 1), random.stepped(0, 5, 1), random.stepped(0, 5, 1));
      obstacles.push_back({low, low + size});
    }
    const auto found = empty_box(seed, limits, obstacles);
    const bool blocked = std::any_of(obstacles.begin(), obstacles.end(),
                                     [&](const Aabb& o) { return overlap(o, seed); });
    ASSERT_EQ(found.has_value(), !blocked);
    if (blocked) continue;
    ++tried;
    EXPECT_TRUE(found->largest);
    EXPECT_TRUE(contains(found->box, seed.min) && contains(found->box, seed.max));
    EXPECT_EQ((found->box.max - found->box.min).prod(), brute_force(seed, limits, obstacles));
  }
}

TEST(EmptyBox, IsNothingForASeedOutsideTheLimits) {
  EXPECT_FALSE(empty_box({{0, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, {1, 5, 5}}, {}));
}

TEST(EmptyBox, AnswersWhereTheSearchGivesUp) {
  support::Random random(4);
  std::vector<Aabb> dust;
  for (int i = 0; i < 400; ++i) {
    const Vec3 p(random.uniform(0, 50), random.uniform(0, 50), random.uniform(0, 50));
    if ((p - Vec3(25, 25, 25)).cwiseAbs().maxCoeff() > 1) dust.push_back({p, p});
  }
  const Aabb limits{Vec3::Zero(), {50, 50, 50}};
  const auto found = empty_box({{25, 25, 25}, {25, 25, 25}}, limits, dust, 3);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->largest);
  for (const Aabb& d : dust) {
    EXPECT_FALSE((d.min.array() < found->box.max.array()).all() &&
                 (d.max.array() > found->box.min.array()).all());
  }
}

}  // namespace
}  // namespace geom
