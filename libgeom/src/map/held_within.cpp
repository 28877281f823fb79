#include "held_within.h"

#include <algorithm>
#include <limits>

#include "box_runs.h"

namespace geom {
namespace {

constexpr std::size_t kMostGapBoxes = 1000;
constexpr double kLowRow = 1e-6;  // m: far more than rounding

bool holds_all(const Aabb& box, const Aabb& reach) {
  return box.min.z() <= reach.min.z() && box.max.z() >= reach.max.z() &&
         box.min.x() <= reach.min.x() && box.max.x() >= reach.max.x() &&
         box.min.y() <= reach.min.y() && box.max.y() >= reach.max.y();
}

}  // namespace

Aabb reach_of(const Footprint& f) {
  Vec2 low = f.polygon.outer.front();
  Vec2 high = low;
  for (const Vec2& p : f.polygon.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {{low.x(), low.y(), f.bottom}, {high.x(), high.y(), f.top}};
}

bool HeldWithin::operator()(const Footprint& f, std::span<const Aabb> boxes) {
  const Aabb reach = reach_of(f);
  near_.clear();
  for (const Aabb& box : boxes) {
    if (!is_as_high(box, reach)) continue;
    if (holds_all(box, reach)) return true;
    near_.push_back(box);
  }
  return holds_walls(f.polygon.outer) &&
         std::all_of(f.polygon.holes.begin(), f.polygon.holes.end(),
                     [&](const auto& hole) { return holds_walls(hole); }) &&
         !leaves_gap(f.polygon, reach);
}

// The part of the segment in the box.
std::optional<HeldWithin::Stretch> HeldWithin::part_in(const Aabb& box, const Vec2& a,
                                                       const Vec2& b) {
  Stretch inside{0, 1};
  for (int i = 0; i < 2; ++i) {
    if (std::max(a[i], b[i]) < box.min[i] || std::min(a[i], b[i]) > box.max[i]) return std::nullopt;
    const double step = b[i] - a[i];
    if (step == 0) continue;
    const double u = (box.min[i] - a[i]) / step;
    const double v = (box.max[i] - a[i]) / step;
    inside.from = std::max(inside.from, std::min(u, v));
    inside.to = std::min(inside.to, std::max(u, v));
  }
  if (inside.from > inside.to) return std::nullopt;
  return inside;
}

bool HeldWithin::holds_wall(const Vec2& a, const Vec2& b) {
  stretches_.clear();
  for (const Aabb& box : near_) {
    if (const auto part = part_in(box, a, b)) stretches_.push_back(*part);
  }
  std::sort(stretches_.begin(), stretches_.end(),
            [](const Stretch& s, const Stretch& t) { return s.from < t.from; });
  double reached = 0;
  for (const Stretch& part : stretches_) {
    if (part.from > reached) return false;
    reached = std::max(reached, part.to);
  }
  return !stretches_.empty() && reached >= 1;
}

bool HeldWithin::holds_walls(const std::vector<Vec2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!holds_wall(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0])) return false;
  }
  return true;
}

// Where boxes begin and end along y within the reach, in order.
void HeldWithin::cut_rows(const Aabb& reach) {
  const auto add = [&](double y) {
    if (y > reach.min.y() && y < reach.max.y()) rows_.push_back(y);
  };
  rows_ = {reach.min.y()};
  for (const InPlan& box : coming_) add(box.y0);
  const auto begins = static_cast<std::ptrdiff_t>(rows_.size());
  for (const InPlan& box : coming_) add(box.y1);
  std::sort(rows_.begin() + begins, rows_.end());
  std::inplace_merge(rows_.begin(), rows_.begin() + begins, rows_.end());
  rows_.push_back(reach.max.y());
}

// Whether the polygon holds the middle of a place in the row that none of the boxes in it covers,
// and that reaches into `freed`.
bool HeldWithin::has_gap(const Polygon& polygon, const Row& row, const Stretch& freed) const {
  const auto is_gap = [&](double from, double to) {
    return from < to && from < freed.to && to > freed.from &&
           contains(polygon, {0.5 * (from + to), row.y});
  };
  double reached = row.x0;
  for (const InPlan& box : in_row_) {
    if (is_gap(reached, std::min(box.x0, row.x1))) return true;
    reached = std::max(reached, box.x1);
  }
  return is_gap(reached, row.x1);
}

// Whether the polygon, whose edges lie within the boxes, holds a place that none of them does. The
// boxes' sides cut the rectangle around it into rows. A gap is what no box covers between two boxes
// of a row. No edge enters a gap, so all of it is inside the polygon, or nothing. The same is true
// of a gap together with one in the row above, unless a box lies between them. So a row's gaps are
// looked at only where a box ended below them, or a flat one lies. Rounding may open gaps in a low
// row, so the row above it is looked at, too.
bool HeldWithin::leaves_gap(const Polygon& polygon, const Aabb& reach) {
  if (near_.size() > kMostGapBoxes) return true;  // not worth looking: it gets boxes of its own
  coming_.clear();
  for (const Aabb& box : near_) {
    coming_.push_back({box.min.x(), box.max.x(), box.min.y(), box.max.y()});
  }
  std::sort(coming_.begin(), coming_.end(),
            [](const InPlan& a, const InPlan& b) { return a.y0 < b.y0; });
  cut_rows(reach);
  in_row_.clear();
  auto next = coming_.begin();
  double first_end = reach.max.y();  // no box of the row ends before it
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Stretch freed{-kInfinity, kInfinity};  // in x
  for (std::size_t j = 0; j + 1 < rows_.size(); ++j) {
    const double y = rows_[j];
    if (y == rows_[j + 1]) continue;
    if (first_end <= y) {
      std::erase_if(in_row_, [&](const InPlan& box) {
        if (box.y1 > y) return false;
        freed = freed.with(box);
        return true;
      });
      first_end = reach.max.y();
      for (const InPlan& box : in_row_) first_end = std::min(first_end, box.y1);
    }
    for (; next != coming_.end() && next->y0 <= y; ++next) {
      if (next->y1 <= y) {
        freed = freed.with(*next);
        continue;
      }
      in_row_.insert(std::upper_bound(in_row_.begin(), in_row_.end(), *next,
                                      [](const InPlan& a, const InPlan& b) { return a.x0 < b.x0; }),
                     *next);
      first_end = std::min(first_end, next->y1);
    }
    if (freed.from > freed.to) continue;
    const Row row{0.5 * (y + rows_[j + 1]), reach.min.x(), reach.max.x()};
    if (has_gap(polygon, row, freed)) return true;
    if (rows_[j + 1] - y > kLowRow) freed = {kInfinity, -kInfinity};
  }
  return false;
}

}  // namespace geom
