#pragma once

// The bends of a roadmap in boxes within boxes, so that a search meets first those that are near
// and never those that are far.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plan/roadmap/roadmap.h"

namespace plan {

// Leaves are runs of bends that follow each other, as the bends of one box do; leaves that are near
// each other along a Morton curve have a common parent. Immutable; building sorts the leaves.
class BendTree {
 public:
  static constexpr std::size_t kBendsOfLeaf = 16;  // at most
  static constexpr std::size_t kChildren = 4;      // of a node, at most

  // What is below node i lies in its box, the faces included. A leaf has the bends [first, first +
  // count), another node has the nodes [first, first + count).
  struct Node {
    float min[3];
    float max[3];
    std::uint32_t first;
    std::uint16_t count;
    bool leaf;
  };

  explicit BendTree(std::span<const Bend> bends);

  bool empty() const { return nodes_.empty(); }
  std::size_t size() const { return nodes_.size(); }
  std::uint32_t root() const { return static_cast<std::uint32_t>(nodes_.size() - 1); }
  const Node& node(std::uint32_t i) const { return nodes_[i]; }

  // How far `p` is from the node's box, in metres: no more than (p - q).norm() for any bend at q in
  // it, as rounded too.
  static double distance(const Node& node, const Vec3& p) {
    return std::sqrt(squared_distance(node, p));
  }
  static double squared_distance(const Node& node, const Vec3& p);

  static geom::Aabb box(const Node& node);

  // The boxes of a node's children, for a look at all of them at once. Children that a node lacks
  // are infinitely far from everything.
  struct Children {
    float min[3][kChildren];
    float max[3][kChildren];
  };
  // Of a node that is no leaf.
  const Children& children(std::uint32_t i) const { return children_[i - leaves_]; }

  // Calls f(first, count) for the bends of leaves, from the root down. Of node i, which is no leaf,
  // it goes into the children whose bits are in pick(i).
  template <class Pick, class F>
  void for_leaves(const Pick& pick, const F& f) const {
    if (!empty()) for_leaves(root(), pick, f);
  }

 private:
  template <class Pick, class F>
  void for_leaves(std::uint32_t i, const Pick& pick, const F& f) const {
    const Node& node = nodes_[i];
    if (node.leaf) {
      f(node.first, std::uint32_t{node.count});
      return;
    }
    for (unsigned mask = pick(i); mask != 0; mask &= mask - 1) {
      for_leaves(node.first + static_cast<std::uint32_t>(std::countr_zero(mask)), pick, f);
    }
  }

  std::vector<Node> nodes_;  // children before their parents, leaves first; the root is the last
  std::size_t leaves_ = 0;
  std::vector<Children> children_;  // of each that is no leaf
};

// Rounding keeps the order of differences, squares, sums and square roots, so the distance to the
// box is not above that to a point of it where both are worked out in the same way.
inline double BendTree::squared_distance(const Node& node, const Vec3& p) {
  const auto out = [&](int k) {
    const double below = node.min[k] - p[k];
    const double above = p[k] - node.max[k];
    const double off = below > above ? below : above;
    return off > 0 ? off : 0;
  };
  const double x = out(0);
  const double y = out(1);
  const double z = out(2);
  return x * x + y * y + z * z;  // as squaredNorm() adds
}

}  // namespace plan
