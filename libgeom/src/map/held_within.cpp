#include "held_within.h"

#include <algorithm>

#include "box_runs.h"

namespace geom {
namespace {

constexpr std::size_t kMostGapBoxes = 1000;

bool holds_all(const Aabb& box, const Aabb& reach) {
  return box.min.z() <= reach.min.z() && box.max.z() >= reach.max.z() &&
         box.min.x() <= reach.min.x() && box.max.x() >= reach.max.x() &&
         box.min.y() <= reach.min.y() && box.max.y() >= reach.max.y();
}

struct Row {
  double y;
  double low;  // x
  double high;
};

// Whether the polygon holds the middle of a place in the row that none of the boxes covers; these
// are in the order of their lower x.
bool has_gap(const Polygon& polygon, const std::vector<const Aabb*>& boxes, const Row& row) {
  const auto is_gap = [&](double from, double to) {
    return from < to && contains(polygon, {0.5 * (from + to), row.y});
  };
  double reached = row.low;
  for (const Aabb* box : boxes) {
    if (is_gap(reached, std::min(box->min.x(), row.high))) return true;
    reached = std::max(reached, box->max.x());
  }
  return is_gap(reached, row.high);
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

// Whether the polygon, whose edges lie within the boxes, holds a place that none of them does. The
// boxes' sides cut the rectangle around it into rows. No edge enters what no box covers between two
// boxes of a row, so that lies inside the polygon as a whole or outside as a whole.
bool HeldWithin::leaves_gap(const Polygon& polygon, const Aabb& reach) {
  if (near_.size() > kMostGapBoxes) return true;  // not worth looking: it gets boxes of its own
  rows_ = {reach.min.y(), reach.max.y()};
  for (const Aabb& box : near_) {
    for (const double y : {box.min.y(), box.max.y()}) {
      if (y > reach.min.y() && y < reach.max.y()) rows_.push_back(y);
    }
  }
  std::sort(rows_.begin(), rows_.end());
  std::sort(near_.begin(), near_.end(),
            [](const Aabb& a, const Aabb& b) { return a.min.y() < b.min.y(); });
  in_row_.clear();  // by their lower x
  auto next = near_.begin();
  for (std::size_t j = 0; j + 1 < rows_.size(); ++j) {
    if (rows_[j] == rows_[j + 1]) continue;
    std::erase_if(in_row_, [&](const Aabb* box) { return box->max.y() <= rows_[j]; });
    for (; next != near_.end() && next->min.y() <= rows_[j]; ++next) {
      if (next->max.y() <= rows_[j]) continue;
      in_row_.insert(
          std::upper_bound(in_row_.begin(), in_row_.end(), &*next,
                           [](const Aabb* a, const Aabb* b) { return a->min.x() < b->min.x(); }),
          &*next);
    }
    const double middle = 0.5 * (rows_[j] + rows_[j + 1]);
    if (has_gap(polygon, in_row_, {middle, reach.min.x(), reach.max.x()})) return true;
  }
  return false;
}

}  // namespace geom
