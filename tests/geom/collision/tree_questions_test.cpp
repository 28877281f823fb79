#include "collision/tree_questions.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

const TreeFrame kFrame({{100, 200, 0}, {400, 300, 50}});

TEST(SegmentInTree, BeyondAllBoxesIsOutside) {
  EXPECT_TRUE(SegmentInTree(kFrame, {1e7, 250, 0}, {1e7, 255, 0}).outside);
  EXPECT_FALSE(SegmentInTree(kFrame, {1e7, 250, 0}, {-1e7, 250, 0}).outside);
}

TEST(SegmentInTree, IsRelativeToTheCorner) {
  const SegmentInTree s(kFrame, {110, 220, 10}, {112, 216, 10});
  EXPECT_EQ(s.inverse[0], 0.5f);
  EXPECT_EQ(s.inverse[1], -0.25f);
  EXPECT_EQ(s.start[0], -5.0f);
  EXPECT_EQ(s.start[1], 5.0f);
  EXPECT_TRUE(std::isfinite(s.inverse[2]));
}

TEST(SegmentInTree, EntersByTheSideThatItComesFrom) {
  const SegmentInTree s(kFrame, {110, 220, 10}, {112, 216, 10});
  EXPECT_EQ(s.enter[0], 0u);
  EXPECT_EQ(s.leave[0], 3 * BoxNode::kLanes);
  EXPECT_EQ(s.enter[1], 4 * BoxNode::kLanes);
  EXPECT_EQ(s.leave[1], BoxNode::kLanes);
}

TEST(RegionInTree, MayBeInfinite) {
  const Vec3 all = Vec3::Constant(std::numeric_limits<double>::infinity());
  const RegionInTree r(kFrame, {-all, all});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(r.low[i], 0.0f);
    EXPECT_GE(r.high[i], 50.0f);
    EXPECT_TRUE(std::isfinite(r.low[i]) && std::isfinite(r.high[i]));
  }
}

TEST(PointInTree, LimitsTheSquareFromAbove) {
  const PointInTree near(kFrame, {110, 220, 10});
  EXPECT_GE(near.limit(3), 9.0f);
  EXPECT_LT(near.limit(3), 9.01f);
  EXPECT_EQ(near.limit(1e30), std::numeric_limits<float>::infinity());
  // Far outside, single precision loses metres.
  EXPECT_GT(PointInTree(kFrame, {1e9, 220, 10}).limit(0), 1e4f);
}

}  // namespace
}  // namespace geom
