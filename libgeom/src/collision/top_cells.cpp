#include "top_cells.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace geom {
namespace {

constexpr double kBoxesPerCell = 4;     // about, if none reached into two
constexpr std::size_t kMostCopies = 8;  // of a box, on average
constexpr double kMostCells = 1 << 24;

}  // namespace

template <class F>
void TopCells::each_cell(const Aabb& box, const F& f) const {
  const std::size_t x1 = along(box.max.x(), 0);
  const std::size_t y1 = along(box.max.y(), 1);
  for (std::size_t y = along(box.min.y(), 1); y <= y1; ++y) {
    for (std::size_t x = along(box.min.x(), 0); x <= x1; ++x) f(y * columns_ + x);
  }
}

// How many boxes reach into each cell, into node_of_; whether that is little enough.
bool TopCells::count(std::span<const Aabb> boxes) {
  std::size_t left = kMostCopies * boxes.size();
  for (const Aabb& box : boxes) {
    const std::size_t width = along(box.max.x(), 0) - along(box.min.x(), 0) + 1;
    const std::size_t height = along(box.max.y(), 1) - along(box.min.y(), 1) + 1;
    if (width * height > left) return false;
    left -= width * height;
    each_cell(box, [&](std::size_t cell) { ++node_of_[cell]; });
  }
  return true;
}

void TopCells::add(const Aabb& box, std::uint32_t child, const TreeFrame& frame) {
  each_cell(box, [&](std::size_t cell) {
    if (node_of_[cell] == kNone) return;
    BoxNode& node = nodes_[node_of_[cell]];
    const auto k = static_cast<std::size_t>(
        std::find(node.child, node.child + BoxNode::kLanes, BoxNode::kNone) - node.child);
    node.child[k] = child;
    for (int i = 0; i < 3; ++i) {
      node.plane[i][k] = frame.low(box, i);
      node.plane[3 + i][k] = frame.high(box, i);
    }
  });
}

TopCells::TopCells(std::span<const Aabb> boxes, const TreeFrame& frame, HugeArena& arena) {
  if (boxes.empty()) return;
  const Aabb all = *bounds(boxes);
  const Eigen::Array2d size = (all.max - all.min).head<2>().cwiseMax(1.0);
  const double cells = static_cast<double>(boxes.size()) / kBoxesPerCell;
  per_metre_ = std::sqrt(cells / size.prod());
  const Eigen::Array2d sides = (size * per_metre_).ceil().max(1.0);
  if (!(sides.prod() <= std::min(kMostCells, 4 * cells + 4))) return;  // long and thin
  low_ = all.min.head<2>();
  last_ = sides - 1;
  columns_ = static_cast<std::size_t>(sides[0]);
  node_of_.assign(static_cast<std::size_t>(sides.prod()), 0);
  if (!count(boxes)) {
    node_of_.clear();
    return;
  }
  std::size_t nodes = 0;
  for (std::uint32_t& n : node_of_)
    n = n <= BoxNode::kLanes ? static_cast<std::uint32_t>(nodes++) : kNone;
  static_assert(HugeArena::kAlign >= alignof(BoxNode));
  nodes_ = static_cast<BoxNode*>(arena.take(nodes * sizeof(BoxNode)));
  std::uninitialized_fill_n(nodes_, nodes, empty_node());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    add(boxes[k], BoxNode::kBox | static_cast<std::uint32_t>(k), frame);
  }
}

}  // namespace geom
