#include "bound/occluders.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Aabb;

const Aabb kRoom{{0, 0, 0}, {20, 20, 20}};

EdgePart part(const Vec3& low, std::uint8_t axis, double length) {
  EdgePart out{low, low, axis, {1, 1}};
  out.high[axis] += length;
  return out;
}

EdgePart place(const Vec3& p) { return {p, p, kCorner, {}}; }

bool hidden(const Occluders& occluders, const EdgePart& a, const EdgePart& b) {
  Hints hints = kNoHints;
  return occluders.between(a, b, hints) == View::hidden;
}

TEST(Occluders, AWallHidesWhatIsWhollyBehindIt) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 10}}}, kRoom);
  const Occluders occluders(scene);
  EXPECT_TRUE(hidden(occluders, part({1, 1, 2}, 2, 5), part({18, 1, 2}, 1, 9)));
  EXPECT_FALSE(hidden(occluders, part({1, 1, 2}, 2, 17), part({18, 1, 2}, 2, 17)));
  EXPECT_FALSE(hidden(occluders, place({1, 1, 12}), place({18, 1, 12})));
}

TEST(Occluders, TouchingIsSeeing) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 10}}}, kRoom);
  const Occluders occluders(scene);
  const double top = scene.grown(0).max.z();
  EXPECT_FALSE(hidden(occluders, place({1, 1, top}), place({18, 1, top})));
  EXPECT_TRUE(hidden(occluders, place({1, 1, top - 1e-9}), place({18, 1, top - 1e-9})));
}

TEST(Occluders, WhatHidOnceIsTriedFirst) {
  const Occluders occluders(scene_of({{{9, 0, 0}, {11, 20, 10}}}, kRoom));
  const EdgePart from = place({1, 1, 2});
  const EdgePart behind = place({18, 1, 2});
  Hints hints = kNoHints;
  EXPECT_FALSE(occluders.hinted(from, behind, hints));
  EXPECT_EQ(occluders.between(from, behind, hints), View::hidden);
  ASSERT_LT(hints.front(), occluders.size());
  EXPECT_TRUE(occluders.hinted(from, place({18, 9, 4}), hints));
  EXPECT_FALSE(occluders.hinted(from, place({18, 1, 19.9}), hints));
  EXPECT_EQ(hints[1], kNoHint);
}

TEST(Occluders, ABoxIsHiddenWhereItsCornersAre) {
  const Occluders occluders(scene_of({{{9, 0, 0}, {11, 20, 10}}}, kRoom));
  const EdgePart from = part({1, 1, 2}, 2, 3);
  Hints hints = kNoHints;
  EXPECT_FALSE(occluders.hinted(from, Aabb{{14, 1, 1}, {18, 19, 4}}, hints));
  EXPECT_TRUE(occluders.between(from, place({18, 1, 2}), hints) == View::hidden);
  EXPECT_TRUE(occluders.hinted(from, Aabb{{14, 1, 1}, {18, 19, 4}}, hints));
  EXPECT_FALSE(occluders.hinted(from, Aabb{{14, 1, 1}, {18, 19, 19}}, hints));
  EXPECT_FALSE(occluders.hinted(from, Aabb{{8, 1, 1}, {18, 19, 4}}, hints));
}

TEST(Occluders, WhoseMiddlesSeeEachOtherIsClear) {
  const Occluders occluders(scene_of({{{9, 0, 0}, {11, 20, 10}}}, kRoom));
  Hints hints = kNoHints;
  const EdgePart far = part({18, 1, 1}, 2, 8);
  EXPECT_EQ(occluders.between(part({1, 1, 0}, 2, 20), far, hints), View::partial);
  EXPECT_EQ(occluders.between(part({1, 1, 10}, 2, 9), part({18, 1, 9}, 2, 9), hints), View::clear);
  EXPECT_EQ(occluders.between(part({1, 1, 0}, 2, 9), far, hints), View::hidden);
}

TEST(Occluders, BoxesSideBySideAndOnEachOtherHideTogether) {
  const Aabb low{{9, 0, 0}, {11, 20, 5}};
  const Aabb left{{9, 0, 5}, {11, 8, 12}};
  const Aabb right{{9, 8, 5}, {11, 20, 12}};
  const Occluders occluders(scene_of({low, left, right}, kRoom));
  EXPECT_TRUE(hidden(occluders, part({1, 6, 8}, 1, 4), part({18, 6, 8}, 1, 4)));
  EXPECT_TRUE(hidden(occluders, part({1, 3, 4}, 2, 3), part({18, 3, 4}, 2, 3)));
}

TEST(Occluders, NoneAreNeeded) {
  EXPECT_FALSE(hidden(Occluders(scene_of({}, kRoom)), place({1, 1, 1}), place({9, 9, 9})));
}

TEST(Occluders, WhatIsHiddenIsHit) {
  support::Random random(5);
  int found = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto scene = random_scene(seed, 12, 12, Vec3::Constant(0.25));
    const Occluders occluders(scene);
    for (int i = 0; i < 200; ++i) {
      EdgePart parts[2];
      for (EdgePart& p : parts) {
        const Vec3 low(random.stepped(0.25, 11, 0.25), random.stepped(0.25, 11, 0.25),
                       random.stepped(0.25, 11, 0.25));
        p = part(low, static_cast<std::uint8_t>(random.below(3)), random.uniform(0, 2));
      }
      if (!hidden(occluders, parts[0], parts[1])) continue;
      ++found;
      for (int n = 0; n < 10; ++n) {
        const Vec3 a = parts[0].low + random.uniform(0, 1) * (parts[0].high - parts[0].low);
        const Vec3 b = parts[1].low + random.uniform(0, 1) * (parts[1].high - parts[1].low);
        ASSERT_TRUE(scene.hits(a, b));
      }
    }
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
}  // namespace plan
