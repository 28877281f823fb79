#pragma once

// Whether boxes hold a footprint between them.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "geom/map/footprint.h"
#include "geom/shape/aabb.h"

namespace geom {

// The box around the footprint's outer ring, from its bottom to its top.
Aabb reach_of(const Footprint& footprint);

// Asks about one footprint after another, and keeps its memory.
class HeldWithin {
 public:
  // Whether the footprint, taken as flat, lies within the boxes. Rounding may say no, never a wrong
  // yes by more than the 1e-9 m that cover() rounds outward. If more than 1,000 boxes touch the
  // footprint, and none of them holds it alone, the answer is no.
  bool operator()(const Footprint& footprint, std::span<const Aabb> boxes);

 private:
  // A box in plan: closed.
  struct InPlan {
    double x0;
    double x1;
    double y0;
    double y1;
  };

  struct Stretch {
    double from;
    double to;

    Stretch with(const InPlan& box) const { return {std::min(from, box.x0), std::max(to, box.x1)}; }
  };

  struct Row {
    double y;
    double x0;
    double x1;
  };

  static std::optional<Stretch> part_in(const Aabb& box, const Vec2& a, const Vec2& b);
  bool holds_wall(const Vec2& a, const Vec2& b);
  bool holds_walls(const std::vector<Vec2>& ring);
  bool leaves_gap(const Polygon& polygon, const Aabb& reach);
  void cut_rows(const Aabb& reach);
  bool has_gap(const Polygon& polygon, const Row& row, const Stretch& freed) const;

  std::vector<Aabb> near_;  // boxes that may touch the footprint, and are as high
  std::vector<Stretch> stretches_;
  std::vector<double> rows_;
  std::vector<InPlan> coming_;  // the same boxes, by their lower y
  std::vector<InPlan> in_row_;  // by their lower x
};

}  // namespace geom
