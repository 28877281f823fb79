#pragma once

// The bends of a roadmap in boxes within boxes, so that a search meets first those that are near
// and never those that are far.

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

  static geom::Aabb box(const Node& node);

  // Calls f(first, count) for the bends of all leaves whose squared distance from `p` is at most
  // radius * radius (metres), but for those below nodes i, at a squared distance s, for which
  // skip(i, s) is true.
  template <class Skip, class F>
  void for_leaves_near(const Vec3& p, double radius, const Skip& skip, const F& f) const {
    if (!empty()) for_leaves_near(root(), p, radius * radius, skip, f);
  }

 private:
  static double squared_distance(const Node& node, const Vec3& p);

  template <class Skip, class F>
  void for_leaves_near(std::uint32_t i, const Vec3& p, double square, const Skip& skip,
                       const F& f) const {
    const Node& node = nodes_[i];
    const double apart = squared_distance(node, p);
    if (apart > square || skip(i, apart)) return;
    if (node.leaf) {
      f(node.first, std::uint32_t{node.count});
      return;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      for_leaves_near(k, p, square, skip, f);
    }
  }

  std::vector<Node> nodes_;  // children before their parents; the root is the last
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
