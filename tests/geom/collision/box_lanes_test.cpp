#include "collision/box_lanes.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/random_city.h"

// What each kind of processor says of the children of one node, beside the exact predicates.

namespace geom {
namespace {

struct Node {
  std::vector<Aabb> boxes;
  TreeFrame frame;
  BoxNode node;
};

Node node_of(support::Random& random, std::size_t count) {
  Node out;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 low;
    Vec3 length;
    for (int k = 0; k < 3; ++k) {
      low[k] = random.stepped(-32, 32, 4);
      length[k] = random.below(3) ? random.stepped(0, 32, 4) : 0;
    }
    out.boxes.push_back({low, low + length});
  }
  out.frame = TreeFrame(*bounds(out.boxes));
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    out.node.child[k] = k < count ? static_cast<std::uint32_t>(k) | BoxNode::kBox : BoxNode::kNone;
    for (int i = 0; i < 3; ++i) {
      out.node.plane[i][k] = std::numeric_limits<float>::infinity();
      out.node.plane[i + 3][k] = -std::numeric_limits<float>::infinity();
      if (k >= count) continue;
      const double corner = out.frame.corner[i];
      out.node.plane[i][k] = float_down(out.boxes[k].min[i] - corner - out.frame.pad);
      out.node.plane[i + 3][k] = float_up(out.boxes[k].max[i] - corner + out.frame.pad);
    }
  }
  return out;
}

Vec3 point(support::Random& random) {
  return {random.stepped(-48, 48, 4), random.stepped(-48, 48, 4), random.uniform(-48, 48)};
}

template <class Lanes>
void expect_all(const Node& n, const Vec3& a, const Vec3& b) {
  const SegmentInTree segment(n.frame, a, b);
  const Aabb region{a.cwiseMin(b), a.cwiseMax(b)};
  const PointInTree at(n.frame, a);
  const double radius = distance(a, n.boxes.front());
  std::array<float, BoxNode::kLanes> squares;
  const unsigned on = Lanes::on(n.node, segment);
  const unsigned in = Lanes::in(n.node, RegionInTree(n.frame, region));
  const unsigned near = Lanes::near(n.node, at, at.limit(radius), squares.data());
  const unsigned nearest = Lanes::nearest(n.node, at);
  ASSERT_LT(nearest, n.boxes.size());
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    const unsigned bit = 1u << k;
    if (k >= n.boxes.size()) {
      EXPECT_EQ((on | in | near) & bit, 0u);
      continue;
    }
    if (segment_hits(a, b, n.boxes[k])) {
      EXPECT_NE(on & bit, 0u);
    }
    if (overlap(region, n.boxes[k])) {
      EXPECT_NE(in & bit, 0u);
    }
    if (distance(a, n.boxes[k]) <= radius) {
      EXPECT_NE(near & bit, 0u);
    }
    EXPECT_NEAR(std::sqrt(squares[k]), distance(a, n.boxes[k]), 0.01);
    EXPECT_LE(squares[nearest], squares[k]);
    // And little else.
    const Aabb wide{n.boxes[k].min - Vec3::Constant(0.01), n.boxes[k].max + Vec3::Constant(0.01)};
    if (!segment_hits(a, b, wide)) {
      EXPECT_EQ(on & bit, 0u);
    }
    if (!overlap(region, wide)) {
      EXPECT_EQ(in & bit, 0u);
    }
    if (distance(a, n.boxes[k]) > radius + 0.01) {
      EXPECT_EQ(near & bit, 0u);
    }
  }
}

template <class Lanes>
void expect_pushes(const Node& n, unsigned mask) {
  std::array<std::uint32_t, 2 * BoxNode::kLanes> open;
  const std::size_t count = Lanes::push(n.node, mask, open.data());
  std::size_t next = 0;
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    if ((mask >> k & 1) != 0) {
      EXPECT_EQ(open[next++], n.node.child[k]);
    }
  }
  EXPECT_EQ(count, next);
}

template <class Lanes>
class BoxLanes : public testing::Test {};

#if defined(__x86_64__)
using Kinds = testing::Types<lanes::Plain, lanes::Avx2, lanes::Avx512>;
#else
using Kinds = testing::Types<lanes::Plain>;
#endif
TYPED_TEST_SUITE(BoxLanes, Kinds);

TYPED_TEST(BoxLanes, LetThroughWhatIsMetAndLittleElse) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(7);
  for (int i = 0; i < support::cases(3000); ++i) {
    const Node n = node_of(random, static_cast<std::size_t>(1 + random.below(16)));
    const Vec3 a = point(random);
    Vec3 b = random.below(4) ? point(random) : a;
    if (random.below(2)) b[random.below(3)] = a[random.below(3)];
    expect_all<TypeParam>(n, a, b);
    if (this->HasFailure()) FAIL() << "case " << i;
  }
}

TYPED_TEST(BoxLanes, PushTheChildrenOfAMaskInOrder) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(8);
  const Node n = node_of(random, BoxNode::kLanes);
  for (unsigned mask = 0; mask < 0x10000; ++mask) expect_pushes<TypeParam>(n, mask);
}

TEST(RegionInTree, MayBeInfinite) {
  support::Random random(9);
  const Node n = node_of(random, 16);
  const Vec3 all = Vec3::Constant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(lanes::Plain::in(n.node, RegionInTree(n.frame, {-all, all})), 0xffffu);
}

TEST(SegmentInTree, BeyondAllBoxesIsOutside) {
  support::Random random(10);
  const Node n = node_of(random, 16);
  EXPECT_TRUE(SegmentInTree(n.frame, {1e7, 0, 0}, {1e7, 5, 0}).outside);
  EXPECT_FALSE(SegmentInTree(n.frame, {1e7, 0, 0}, {-1e7, 0, 0}).outside);
}

}  // namespace
}  // namespace geom
