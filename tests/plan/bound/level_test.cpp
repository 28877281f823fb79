#include "bound/level.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

const EdgePart kNear{{5, 1, 0}, {5, 1, 4}, 2, {1, -1}};
const EdgePart kFar{{5, 50, 0}, {5, 50, 4}, 2, {1, 1}};
const EdgePart kCornerPart{{5, 2, 0}, {5, 2, 0}, kCorner, {}};

TEST(Level, TheFirstHasWhatAShortPathReaches) {
  const Level level =
      first_level(PartTree({kNear, kFar, kCornerPart}), {0, 0, 0}, {10, 0, 0}, 20, 1e-12);
  ASSERT_EQ(level.parts.size(), 4u);  // the ends, the near part and the corner
  EXPECT_EQ(level.parts[kStart].low, Vec3(0, 0, 0));
  EXPECT_EQ(level.parts[kGoal].low, Vec3(10, 0, 0));
  EXPECT_EQ(level.parts[2].high, kNear.high);
  EXPECT_EQ(level.come.size(), 8u);
  EXPECT_EQ(level.links.size(), 4u);
}

TEST(Level, TheFirstKnowsStraightLines) {
  const Level level = first_level(PartTree({kNear, kCornerPart}), {0, 0, 0}, {10, 0, 0}, 20, 1e-12);
  EXPECT_EQ(level.come[2 * kStart], (LineLabel{0, 0}));
  EXPECT_EQ(level.go[2 * kGoal], (LineLabel{0, 0}));
  EXPECT_NEAR(level.go[2 * kStart].low, 10, 1e-9);
  for (const State s : {4, 5}) {
    EXPECT_LE(level.come[s].low, std::sqrt(26.0));
    EXPECT_LE(level.come[s].high, std::sqrt(42.0));
    EXPECT_GT(level.come[s].least(), 4);
  }
  EXPECT_NEAR(level.come[6].low, std::sqrt(29.0), 1e-9);
  EXPECT_FALSE(level.come[7].is_set());  // a corner has one side
}

TEST(Level, GroupsHoldTheirPartsAndTheEndsAreAlone) {
  std::vector<EdgePart> parts;
  for (int i = 0; i < 40; ++i) parts.push_back({Vec3(i, 1, 0), Vec3(i, 1, 4), 2, {1, -1}});
  const Level level = first_level(PartTree(parts), {0, 0, 0}, {40, 0, 0}, 100, 1e-12);
  ASSERT_EQ(level.parts.size(), 42u);
  EXPECT_EQ(level.groups.at(0).end, 1u);
  EXPECT_EQ(level.groups.at(1).end, 2u);
  EXPECT_EQ(level.groups.back().end, 42u);
  std::uint32_t i = 0;
  for (const PartGroup& group : level.groups) {
    EXPECT_LT(i, group.end);
    for (; i < group.end; ++i) {
      EXPECT_TRUE(geom::contains(group.box, level.parts[i].low));
      EXPECT_TRUE(geom::contains(group.box, level.parts[i].high));
      EXPECT_LE(group.go, least(level.go, i));
    }
  }
}

TEST(Level, APathLeavesToTheOtherSide) {
  EXPECT_TRUE(leaves(kNear, 0, 2));
  EXPECT_FALSE(leaves(kNear, 0, 1));
  EXPECT_TRUE(leaves(kNear, 1, 1));
  EXPECT_TRUE(leaves(kCornerPart, 0, 3));
}

}  // namespace
}  // namespace plan
