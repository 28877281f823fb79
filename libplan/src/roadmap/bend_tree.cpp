#include "bend_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "curve.h"
#include "geom/base/rounding.h"

namespace plan {
namespace {

BendTree::Node leaf_of(std::span<const Bend> bends, std::size_t first) {
  const std::size_t count = std::min(BendTree::kBendsOfLeaf, bends.size() - first);
  BendTree::Node leaf{
      {}, {}, static_cast<std::uint32_t>(first), static_cast<std::uint16_t>(count), true};
  for (int k = 0; k < 3; ++k) {
    double low = bends[first].position[k];
    double high = low;
    for (std::size_t i = first + 1; i < first + count; ++i) {
      low = std::min(low, bends[i].position[k]);
      high = std::max(high, bends[i].position[k]);
    }
    leaf.min[k] = geom::float_down(low);
    leaf.max[k] = geom::float_up(high);
  }
  return leaf;
}

BendTree::Node parent_of(std::span<const BendTree::Node> children, std::size_t first) {
  BendTree::Node parent = children[0];
  parent.first = static_cast<std::uint32_t>(first);
  parent.count = static_cast<std::uint16_t>(children.size());
  parent.leaf = false;
  for (const BendTree::Node& child : children) {
    for (int k = 0; k < 3; ++k) {
      parent.min[k] = std::min(parent.min[k], child.min[k]);
      parent.max[k] = std::max(parent.max[k], child.max[k]);
    }
  }
  return parent;
}

BendTree::Children children_of(std::span<const BendTree::Node> children) {
  constexpr float kNowhere = std::numeric_limits<float>::infinity();
  BendTree::Children out;
  for (std::size_t k = 0; k < BendTree::kChildren; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.min[axis][k] = k < children.size() ? children[k].min[axis] : kNowhere;
      out.max[axis][k] = k < children.size() ? children[k].max[axis] : -kNowhere;
    }
  }
  return out;
}

// Along a curve.
void sort_leaves(std::vector<BendTree::Node>& leaves) {
  if (leaves.empty()) return;
  const Curve curve(BendTree::box(parent_of(leaves, 0)));
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
  places.reserve(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const geom::Aabb box = BendTree::box(leaves[i]);
    places.emplace_back(curve.place(0.5 * (box.min + box.max)), static_cast<std::uint32_t>(i));
  }
  std::sort(places.begin(), places.end());
  std::vector<BendTree::Node> sorted;
  sorted.reserve(leaves.size());
  for (const auto& [place, i] : places) sorted.push_back(leaves[i]);
  leaves = std::move(sorted);
}

}  // namespace

BendTree::BendTree(std::span<const Bend> bends) {
  for (std::size_t first = 0; first < bends.size(); first += kBendsOfLeaf) {
    nodes_.push_back(leaf_of(bends, first));
  }
  sort_leaves(nodes_);
  leaves_ = nodes_.size();
  std::size_t begin = 0;
  for (std::size_t end = nodes_.size(); end - begin > 1; end = nodes_.size()) {
    for (; begin < end; begin += kChildren) {
      const std::size_t count = std::min(kChildren, end - begin);
      const auto children = std::span(nodes_).subspan(begin, count);
      children_.push_back(children_of(children));
      nodes_.push_back(parent_of(children, begin));
    }
    begin = end;
  }
}

geom::Aabb BendTree::box(const Node& node) {
  return {Vec3(node.min[0], node.min[1], node.min[2]), Vec3(node.max[0], node.max[1], node.max[2])};
}

}  // namespace plan
