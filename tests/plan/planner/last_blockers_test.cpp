#include "planner/last_blockers.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(LastBlockers, RefuseWhatIsNoPointAsTheSceneDoes) {
  const auto scene = scene_of({{{9, 0, 0}, {11, 20, 20}}}, kCube);
  LastBlockers asked(scene);
  EXPECT_TRUE(asked.hits({1, 1, 1}, {19, 1, 1}));
  EXPECT_ANY_THROW(asked.hits({1, 1, 1}, {std::nan(""), 1, 1}));
  EXPECT_ANY_THROW(scene.hits({1, 1, 1}, {std::nan(""), 1, 1}));
}

}  // namespace
}  // namespace plan
