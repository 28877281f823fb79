#include "path/blocker_lanes.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

// Whole numbers now and then, so that segments touch corners, edges and faces, and rounding leaves
// a doubt.
double number(support::Random& random) {
  const double x = random.uniform(-12, 12);
  return random.below(2) ? std::floor(x) : x;
}
Vec3 place(support::Random& random) { return {number(random), number(random), number(random)}; }
geom::Aabb box_of(support::Random& random) {
  const Vec3 one = place(random);
  const Vec3 other = place(random);
  return {one.cwiseMin(other), one.cwiseMax(other)};
}

TEST(BlockerLanes, HitAsTheExactTestDoes) {
  support::Random random(1);
  int hits = 0;
  int misses = 0;
  for (int n = 0; n < 100'000; ++n) {
    BlockerLanes lanes;
    std::array<geom::Aabb, BlockerLanes::kLanes> boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) lanes.put(i, boxes[i] = box_of(random));
    const Vec3 a = place(random);
    Vec3 b = random.below(50) ? place(random) : a;
    if (random.below(3) == 0) {  // past an edge of a box, to rounding
      const geom::Aabb& box = boxes[random.below(boxes.size())];
      const Vec3 edge(box.min.x(), box.max.y(), random.uniform(box.min.z(), box.max.z()));
      b = a + (edge - a) * random.uniform(1.1, 3);
    }
    const unsigned hit = lanes.hit_by(a, b);
    ASSERT_EQ(hit, lanes.hit_one_by_one(a, b)) << "case " << n;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const bool expected = geom::segment_hits(a, b, boxes[i]);
      ASSERT_EQ((hit >> i & 1) != 0, expected) << "case " << n;
      (expected ? hits : misses) += 1;
    }
  }
  EXPECT_GT(hits, 50'000);
  EXPECT_GT(misses, 50'000);
}

TEST(BlockerLanes, WithoutBoxesHitAndHideNothing) {
  BlockerLanes lanes;
  EXPECT_EQ(lanes.hit_by({0, 0, 0}, {1, 1, 1}), 0u);
  EXPECT_EQ(lanes.hiding({0, 0, 0}, {{1, 1, 1}, {2, 2, 2}}), 0u);
  lanes.put(2, {{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(lanes.hit_by({-1, 0.5, 0.5}, {2, 0.5, 0.5}), 4u);
  EXPECT_EQ(lanes.hiding({-1, 0.5, 0.5}, {{2, 0.5, 0.5}, {2, 0.5, 0.5}}), 4u);
}

TEST(BlockerLanes, HideAsOneByOneAndOnlyWhatIsBlocked) {
  support::Random random(2);
  int hidden = 0;
  for (int n = 0; n < 100'000; ++n) {
    BlockerLanes lanes;
    std::array<geom::Aabb, BlockerLanes::kLanes> boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) lanes.put(i, boxes[i] = box_of(random));
    const Vec3 eye = 2 * place(random);
    const Vec3 corner = place(random);
    const geom::Aabb box{corner, corner + Vec3::Constant(random.uniform(0, 3))};
    const unsigned mask = lanes.hiding(eye, box);
    ASSERT_EQ(mask, lanes.hiding_one_by_one(eye, box)) << "case " << n;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if ((mask >> i & 1) == 0) continue;
      ++hidden;
      for (unsigned k = 0; k < 8; ++k) {
        const Vec3 p((k & 1 ? box.max : box.min).x(), (k & 2 ? box.max : box.min).y(),
                     (k & 4 ? box.max : box.min).z());
        ASSERT_TRUE(geom::segment_hits(eye, p, boxes[i])) << "case " << n;
      }
    }
  }
  EXPECT_GT(hidden, 2'000);
}

}  // namespace
}  // namespace plan
