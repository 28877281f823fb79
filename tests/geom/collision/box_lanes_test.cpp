#include "collision/box_lanes.h"

#include <gtest/gtest.h>

#include "geom/base/precondition.h"
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

// Which child push_near gives as the nearest; the others that are near, as `near` says, must be on
// the stacks.
template <class Lanes>
unsigned nearest_of(const Node& n, const PointInTree& at, float limit, unsigned near,
                    const std::array<float, BoxNode::kLanes>& squares) {
  std::array<float, 2 * BoxNode::kLanes> square;
  std::array<std::uint32_t, 2 * BoxNode::kLanes> open;
  const lanes::Near found = Lanes::push_near(n.node, at, limit, square.data(), open.data());
  const unsigned nearest = found.nearest & ~BoxNode::kBox;
  unsigned seen = 1u << nearest;
  for (std::size_t i = 0; i < found.others; ++i) {
    const unsigned k = open[i] & ~BoxNode::kBox;
    EXPECT_EQ(seen >> k & 1, 0u);
    seen |= 1u << k;
    EXPECT_EQ(square[i], squares[k]);
  }
  EXPECT_EQ(seen, near);
  return nearest;
}

template <class Lanes>
void expect_all(const Node& n, const Vec3& a, const Vec3& b) {
  const SegmentInTree segment(n.frame, a, b);
  const Aabb region{a.cwiseMin(b), a.cwiseMax(b)};
  const PointInTree at(n.frame, a);
  const double radius = distance(a, n.boxes.front());
  std::array<float, BoxNode::kLanes> squares;
  const lanes::Met met_on = Lanes::on(n.node, segment);
  const unsigned on = met_on.may;
  const lanes::Met met_in = Lanes::in(n.node, RegionInTree(n.frame, region));
  const unsigned in = met_in.may;
  const unsigned near = Lanes::near(n.node, at, at.limit(radius), squares.data());
  const unsigned nearest = nearest_of<Lanes>(n, at, at.limit(radius), near, squares);
  ASSERT_LT(nearest, n.boxes.size());
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    const unsigned bit = 1u << k;
    if (k >= n.boxes.size()) {
      EXPECT_EQ((on | in | near | met_on.surely | met_in.surely) & bit, 0u);
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
    if ((met_on.surely & bit) != 0) {
      EXPECT_TRUE(segment_hits(a, b, n.boxes[k]));
    }
    if ((met_in.surely & bit) != 0) {
      EXPECT_TRUE(overlap(region, n.boxes[k]));
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
    // Doubt is for what barely touches.
    const Aabb less{region.min + Vec3::Constant(0.01), region.max - Vec3::Constant(0.01)};
    if (overlap(less, n.boxes[k])) {
      EXPECT_NE(met_in.surely & bit, 0u);
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

TYPED_TEST(BoxLanes, AreSureOfASegmentThroughTheMiddle) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(12);
  for (int i = 0; i < 300; ++i) {
    const Node n = node_of(random, 16);
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      const Vec3 middle = 0.5 * (n.boxes[k].min + n.boxes[k].max);
      const Vec3 half = 0.5 * (n.boxes[k].max - n.boxes[k].min);
      if (half.minCoeff() < 1) continue;
      const Vec3 d(random.uniform(1, 30), -random.uniform(1, 30), random.uniform(1, 30));
      const SegmentInTree s(n.frame, middle - d, middle + d);
      EXPECT_NE(TypeParam::on(n.node, s).surely >> k & 1, 0u);
    }
  }
}

TYPED_TEST(BoxLanes, PushTheChildrenOfAMaskInOrder) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(8);
  const Node n = node_of(random, BoxNode::kLanes);
  for (unsigned mask = 0; mask < 0x10000; ++mask) expect_pushes<TypeParam>(n, mask);
}

TYPED_TEST(BoxLanes, TellBoxesFromNodes) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  BoxNode node = empty_node();
  for (unsigned mask = 0; mask < 0x10000; mask += 37) {
    for (std::uint32_t k = 0; k < BoxNode::kLanes; ++k) {
      node.child[k] = (mask >> k & 1) != 0 ? BoxNode::kBox | k : 1000 + k;
    }
    EXPECT_EQ(TypeParam::boxes(node), mask);
  }
}

TYPED_TEST(BoxLanes, PushNothingWhereNothingIsNear) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(11);
  const Node n = node_of(random, 5);
  std::array<float, BoxNode::kLanes> square;
  std::array<std::uint32_t, BoxNode::kLanes> open;
  for (const double far : {-kFarthest, kFarthest}) {
    const PointInTree at(n.frame, Vec3::Constant(far));
    const lanes::Near found = TypeParam::push_near(n.node, at, 1, square.data(), open.data());
    EXPECT_EQ(found.nearest, BoxNode::kNone);
    EXPECT_EQ(found.others, 0u);
    constexpr float kAll = std::numeric_limits<float>::infinity();
    const lanes::Near all = TypeParam::push_near(n.node, at, kAll, square.data(), open.data());
    EXPECT_LT(all.nearest & ~BoxNode::kBox, 5u);
    EXPECT_EQ(all.others, 4u);
  }
}

TYPED_TEST(BoxLanes, LetThroughAllThatAnInfiniteRegionHas) {
  if (!TypeParam::usable()) GTEST_SKIP() << "not on this processor";
  support::Random random(9);
  const Node n = node_of(random, 16);
  const Vec3 all = Vec3::Constant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(TypeParam::in(n.node, RegionInTree(n.frame, {-all, all})).may, 0xffffu);
}

}  // namespace
}  // namespace geom
