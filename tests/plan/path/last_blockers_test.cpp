#include "path/last_blockers.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {20, 20, 20}};

Vec3 place(support::Random& random) {
  return {random.uniform(-1, 21), random.uniform(-1, 21), random.uniform(-1, 21)};
}

// Segments from one place to others along a line, as searches ask; and now and then a new line.
TEST(LastBlockers, AnswerAsTheSceneDoes) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    support::Random random(seed);
    const auto scene = random_scene(seed, 60, 20, Vec3(0.5, 0.5, 0.25));
    LastBlockers asked(scene);
    int blocked = 0;
    Vec3 from = place(random);
    Vec3 to = place(random);
    Vec3 step = Vec3::Zero();
    for (int i = 0; i < 20000; ++i) {
      if (i % 50 == 0) {
        from = place(random);
        to = place(random);
        step = (place(random) - to) / 50;
      }
      to += step;
      const bool expected = scene.hits(from, to);
      blocked += expected;
      ASSERT_EQ(asked.hits(from, to), expected) << "case " << i;
      ASSERT_EQ(asked.free(from, to), scene.free(from, to)) << "case " << i;
    }
    EXPECT_GT(blocked, 2000);
    EXPECT_LT(blocked, 18000);
  }
}

TEST(LastBlockers, HoldNothingAgainstASegmentThatIsClear) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 20}}}, kCube);
  LastBlockers asked(scene);
  EXPECT_TRUE(asked.hits({1, 1, 1}, {19, 1, 1}));
  EXPECT_FALSE(asked.hits({1, 1, 1}, {1, 19, 1}));
  EXPECT_TRUE(asked.hits({1, 1, 1}, {9, 1, 1}));    // touches
  EXPECT_FALSE(asked.free({1, 1, 1}, {1, 21, 1}));  // out of bounds
}

// A box that is hidden, as tests ask: blocked by the one box of the scene at every corner.
TEST(LastBlockers, HideOnlyBoxesOfWhichTheyHideEveryPoint) {
  support::Random random(7);
  int hidden = 0;
  int behind = 0;  // of boxes whose corners are all blocked
  for (int i = 0; i < 4000; ++i) {
    const Vec3 low = place(random);
    const Vec3 size(random.uniform(0, 12), random.uniform(0, 12), random.uniform(0, 12));
    const auto scene = scene_of({{low, low + size}}, {{-20, -20, -20}, {60, 60, 60}});
    LastBlockers asked(scene);
    const Vec3 eye = place(random);
    if (!asked.hits(eye, low + size / 2)) continue;
    const Vec3 middle = eye + (low + size / 2 - eye) * random.uniform(0.5, 2.5);
    const auto part = [&] {
      const Vec3 share(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      return Vec3(share.cwiseProduct(size));
    };
    const geom::Aabb box{middle - part(), middle + part()};
    bool all = true;
    for (unsigned k = 0; k < 8; ++k) {
      const Vec3 p((k & 1 ? box.max : box.min).x(), (k & 2 ? box.max : box.min).y(),
                   (k & 4 ? box.max : box.min).z());
      all = all && scene.hits(eye, p);
    }
    behind += all;
    if (!asked.hides(eye, box)) continue;
    ++hidden;
    ASSERT_TRUE(all) << "case " << i;
  }
  EXPECT_GT(hidden, 500);
  EXPECT_GT(2 * hidden, behind);
}

TEST(LastBlockers, HideNothingThatTouchesTheirOutline) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 20}}}, kCube);
  LastBlockers asked(scene);
  const Vec3 eye(1, 10, 10);
  const geom::Aabb box{{13, 10, 10}, {14, 11, 11}};
  EXPECT_FALSE(asked.hides(eye, box));  // nothing blocked a segment yet
  EXPECT_TRUE(asked.hits(eye, {19, 10, 10}));
  EXPECT_TRUE(asked.hides(eye, box));
  EXPECT_FALSE(asked.hides(eye, {{8, 10, 10}, {14, 11, 11}}));   // from before it
  EXPECT_FALSE(asked.hides(eye, {{13, 10, 10}, {14, 11, 25}}));  // over it
  EXPECT_FALSE(asked.hides({10, 10, 10}, box));                  // from inside
}

TEST(LastBlockers, RefuseWhatIsNoPointAsTheSceneDoes) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 20}}}, kCube);
  LastBlockers asked(scene);
  EXPECT_TRUE(asked.hits({1, 1, 1}, {19, 1, 1}));
  EXPECT_ANY_THROW(asked.hits({1, 1, 1}, {std::nan(""), 1, 1}));
  EXPECT_ANY_THROW(scene.hits({1, 1, 1}, {std::nan(""), 1, 1}));
}

}  // namespace
}  // namespace plan
