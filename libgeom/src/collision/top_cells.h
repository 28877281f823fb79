#pragma once

// A way past the upper levels of a tree over what lies side by side on the ground: of each cell of
// a grid, one node of all that reaches into it. Most questions lie in one cell.

#include <cstdint>
#include <span>
#include <vector>

#include "box_tree.h"
#include "huge_arena.h"

namespace geom {

class TopCells {
 public:
  // Box k of `boxes` is child kBox | k. `frame` is of the boxes. About as many cells as a quarter
  // of the boxes; none where many reach over much of the whole. Nodes lie in the arena, which must
  // outlive them. Throws std::bad_alloc.
  TopCells(std::span<const Aabb> boxes, const TreeFrame& frame, HugeArena& arena);

  // The node of the cell that both points are in, and so all between them; null where they are in
  // two, or where more boxes reach into it than a node has children.
  const BoxNode* node(const Vec3& a, const Vec3& b) const {
    if (node_of_.empty()) return nullptr;
    const std::size_t cell = cell_of(a);
    if (cell != cell_of(b) || node_of_[cell] == kNone) return nullptr;
    return &nodes_[node_of_[cell]];
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // A column or row, by the same monotone arithmetic for boxes and questions: what a question meets
  // shares a cell with it.
  std::size_t along(double v, int axis) const {
    return static_cast<std::size_t>(
        std::max(0.0, std::min(last_[axis], (v - low_[axis]) * per_metre_)));
  }
  std::size_t cell_of(const Vec3& p) const { return along(p[1], 1) * columns_ + along(p[0], 0); }

  template <class F>
  void each_cell(const Aabb& box, const F& f) const;
  bool count(std::span<const Aabb> boxes);
  void add(const Aabb& box, std::uint32_t child, const TreeFrame& frame);

  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();  // column, row
  double per_metre_ = 0;
  std::size_t columns_ = 1;
  std::vector<std::uint32_t> node_of_;  // of each cell
  BoxNode* nodes_ = nullptr;
};

}  // namespace geom
