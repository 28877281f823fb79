#pragma once

// A tree over closed boxes with sixteen children a node, which finds candidates. split_tree.h and
// packed_tree.h build it, and box_walk.h asks it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// Child k lies between plane[i][k] and plane[3 + i][k] on axis i. A child that is none has infinity
// and -infinity there, so nothing meets it.
struct alignas(64) BoxNode {
  static constexpr std::size_t kLanes = 16;
  static constexpr std::uint32_t kBox = 0x80000000;   // set: a box, else the index of a node
  static constexpr std::uint32_t kNone = 0xffffffff;  // no child

  float plane[6][kLanes];
  std::uint32_t child[kLanes];
};

// Where a tree lies. Planes are in single precision, relative to a corner and further out by `pad`,
// so the tree only proposes, and whoever asks decides each candidate in double, but for those of
// which a question is sure (tree_questions.h).
struct TreeFrame {
  // Questions are cut to so many metres around the boxes.
  static constexpr double kBeyond = 1000;

  Vec3 corner = Vec3::Zero();
  Aabb reach;      // the boxes, and kBeyond
  double pad = 0;  // metres

  TreeFrame() = default;

  // Within `reach` no number is larger than R = size + kBeyond. A place on a segment is found with
  // an error below 2^-21 R: 2^-24 R for each rounding of the origin, the planes, the product and
  // the sum, twice that for the direction and for its inverse. In double, the corner is taken off
  // with less than 2^-52 of the largest coordinate.
  explicit TreeFrame(const Aabb& extent) : corner(extent.min) {
    const double size = (extent.max - extent.min).maxCoeff();
    const double largest =
        std::max(extent.min.cwiseAbs().maxCoeff(), extent.max.cwiseAbs().maxCoeff());
    const Vec3 beyond = Vec3::Constant(kBeyond);
    reach = {extent.min - beyond, extent.max + beyond};
    pad = std::ldexp(size + kBeyond, -20) + std::ldexp(largest, -48);
  }

  // The planes of a box, between 1 and 1.2 `pad` further out: rounding to single precision changes
  // less than a sixteenth of it.
  float low(const Aabb& box, int axis) const {
    return static_cast<float>(box.min[axis] - corner[axis] - 1.125 * pad);
  }
  float high(const Aabb& box, int axis) const {
    return static_cast<float>(box.max[axis] - corner[axis] + 1.125 * pad);
  }
};

// A node without children.
inline BoxNode empty_node() {
  BoxNode node;
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; ++i) {
    std::fill_n(node.plane[i], BoxNode::kLanes, kNothing);
    std::fill_n(node.plane[3 + i], BoxNode::kLanes, -kNothing);
  }
  std::fill_n(node.child, BoxNode::kLanes, BoxNode::kNone);
  return node;
}

struct BoxTree {
  // No tree is deeper; a walk has room for as many open nodes.
  static constexpr int kMostDepth = 40;

  TreeFrame frame;
  std::vector<BoxNode> nodes;  // the root first

  std::size_t bytes() const { return nodes.capacity() * sizeof(BoxNode); }
};

struct BuiltTree {
  BoxTree tree;
  // The boxes from leaf to leaf: child kBox | k of a node is boxes[order[k]].
  std::vector<std::uint32_t> order;
};

}  // namespace geom
