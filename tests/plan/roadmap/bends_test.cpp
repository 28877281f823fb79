#include "roadmap/bends.h"

#include <gtest/gtest.h>

#include <set>

#include "plan/scenes.h"

namespace plan {
namespace {

using Key = std::tuple<double, double, double, int, int, int>;

std::multiset<Key> keys(const std::vector<Bend>& bends, const ShortWays& ways) {
  std::multiset<Key> out;
  for (const Bend& bend : bends) {
    const Vec3& p = bend.position;
    if (!ways.hold(p)) continue;
    out.insert({p.x(), p.y(), p.z(), bend.axis, bend.outward[0], bend.outward[1]});
  }
  return out;
}

TEST(BendsWithin, AreThoseOfAllBoxesThatTheWaysHold) {
  const auto scene = random_scene(5, 300, 200, {0.5, 0.5, 0.5});
  std::vector<Bend> all;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    add_bends(scene, scene.grown(i), 2, std::nullopt, all);
  }
  support::Random random(5);
  std::size_t most = 0;
  for (int i = 0; i < 50; ++i) {
    Vec3 ends[2];
    for (Vec3& end : ends) {
      for (int k = 0; k < 3; ++k) end[k] = random.uniform(0, 200);
    }
    const ShortWays ways{ends[0], ends[1], (ends[1] - ends[0]).norm() * random.uniform(1, 1.3) + 1};
    const auto found = bends_within(scene, 2, ways, 1000);
    ASSERT_TRUE(found) << i;
    ASSERT_EQ(keys(*found, ways), keys(all, ways)) << i;
    ASSERT_EQ(keys(*found, ways).size(), found->size()) << i;
    most = std::max(most, found->size());
  }
  EXPECT_GT(most, 100u);
}

TEST(BendsWithin, AreNothingWhereTheBoxesAreTooMany) {
  const auto scene = random_scene(5, 300, 200, {0.5, 0.5, 0.5});
  const ShortWays ways{{0, 0, 0}, {200, 200, 200}, 600};
  EXPECT_TRUE(bends_within(scene, 2, ways, 1000));
  EXPECT_FALSE(bends_within(scene, 2, ways, 20));
}

}  // namespace
}  // namespace plan
