#include "free_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <utility>

namespace traj {
namespace {

constexpr double kTouch = 1e-7;  // m: what comes so near to a cell is in it
constexpr double kNudge = 0.02;  // m, at a corner where two cells of the area touch
constexpr std::size_t kNone = -1;
constexpr std::size_t kMostCells = 100'000'000;

enum Cell : std::uint8_t { kFree, kBox, kArea };

// The sides of boxes along one axis, between the bounds.
std::vector<double> cuts(std::span<const PlanBox> boxes, const PlanBox& bounds, int axis) {
  std::vector<double> out{bounds.min(axis), bounds.max(axis)};
  for (const PlanBox& box : boxes) {
    for (const double at : {box.min(axis), box.max(axis)}) {
      if (at > bounds.min(axis) && at < bounds.max(axis)) out.push_back(at);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// Part of an outline between two heights of y: where it begins and ends in x. Empty: low > high.
struct Span {
  double low;
  double high;
};
Span between(const Outline& outline, double y0, double y1) {
  Span out{1e300, -1e300};
  const auto take = [&](double x) { out = {std::min(out.low, x), std::max(out.high, x)}; };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    if (a.y() >= y0 && a.y() <= y1) take(a.x());
    for (const double y : {y0, y1}) {
      if ((a.y() < y) == (b.y() < y)) continue;
      take(a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y())));
    }
  }
  return out;
}

// A cell's column and row in one number, with a border of free cells around all.
class Cells {
 public:
  // Between these cuts, which ascend.
  Cells(std::vector<double> x, std::vector<double> y, std::span<const PlanBox> boxes)
      : x_(std::move(x)),
        y_(std::move(y)),
        columns_(x_.size() + 1),
        rows_(y_.size() + 1),
        cells_(columns_ * rows_, kFree) {
    for (const PlanBox& box : boxes) mark(box);
  }

  // The cells of a region; false where one of them has a box.
  bool add(const Outline& region) {
    const PlanBox box = grown(box_around(region), kTouch);
    bool clear = true;
    for (std::size_t row = from(y_, box.min.y()); row < y_.size() && y_[row - 1] <= box.max.y();
         ++row) {
      const Span span = between(region, y_[row - 1] - kTouch, y_[row] + kTouch);
      if (span.low > span.high) continue;
      for (std::size_t column = from(x_, span.low - kTouch);
           column < x_.size() && x_[column - 1] <= span.high + kTouch; ++column) {
        std::uint8_t& cell = cells_[row * columns_ + column];
        clear = clear && cell != kBox;
        cell = kArea;
      }
    }
    return clear;
  }

  // Joins what is apart by shortest ways of free cells; false where there are none.
  bool join() {
    while (true) {
      const auto first = std::find(cells_.begin(), cells_.end(), kArea);
      if (first == cells_.end()) return false;
      std::vector<std::size_t> before(cells_.size(), kNone);
      const std::deque<std::size_t> found = flood(first - cells_.begin(), before);
      const auto all = std::count(cells_.begin(), cells_.end(), kArea);
      if (static_cast<std::ptrdiff_t>(found.size()) == all) return true;
      const std::size_t met = search(found, before);
      if (met == kNone) return false;
      for (std::size_t at = before[met]; cells_[at] != kArea; at = before[at]) cells_[at] = kArea;
    }
  }

  // Holes without a box, and free cells at corners where two cells of the area touch.
  void fill() {
    fill_holes();
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t row = 1; row < rows_; ++row) {
        for (std::size_t column = 1; column < columns_; ++column)
          changed |= fill_corner(column, row);
      }
      if (changed) fill_holes();
    }
  }

  AreaRings rings() const {
    AreaRings out;
    std::vector<std::array<bool, 4>> seen(cells_.size());
    for (std::size_t at = 0; at < cells_.size(); ++at) {
      if (cells_[at] != kArea) continue;
      for (int side = 0; side < 4; ++side) {
        if (seen[at][side] || cells_[at + step(side)] == kArea) continue;
        std::vector<Vec2> ring = trace(at, side, seen);
        (area_of(ring) > 0 ? out.outer : out.holes.emplace_back()) = std::move(ring);
      }
    }
    return out;
  }

 private:
  // Sides of a cell, counterclockwise: below, right, above, left. The neighbour beyond one.
  std::size_t step(int side) const {
    const std::size_t steps[] = {-columns_, 1, columns_, static_cast<std::size_t>(-1)};
    return steps[side];
  }

  // The first cell, from 1, that ends at or after `at`.
  static std::size_t from(const std::vector<double>& cuts, double at) {
    const auto cut = std::lower_bound(cuts.begin(), cuts.end(), at);
    return std::max<std::size_t>(1, static_cast<std::size_t>(cut - cuts.begin()));
  }

  void mark(const PlanBox& box) {
    for (std::size_t row = from(y_, box.min.y()); row < y_.size() && y_[row - 1] < box.max.y();
         ++row) {
      if (y_[row] <= box.min.y()) continue;
      for (std::size_t column = from(x_, box.min.x());
           column < x_.size() && x_[column - 1] < box.max.x(); ++column) {
        if (x_[column] > box.min.x()) cells_[row * columns_ + column] = kBox;
      }
    }
  }

  bool is_border(std::size_t at) const {
    const std::size_t column = at % columns_;
    const std::size_t row = at / columns_;
    return column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_;
  }

  // The cells of the area that hang together with this one.
  std::deque<std::size_t> flood(std::size_t start, std::vector<std::size_t>& before) const {
    std::deque<std::size_t> found{start};
    before[start] = start;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (int side = 0; side < 4; ++side) {
        const std::size_t next = found[i] + step(side);
        if (cells_[next] != kArea || before[next] != kNone) continue;
        before[next] = found[i];
        found.push_back(next);
      }
    }
    return found;
  }

  // The nearest cell of the area that is not among these, by free cells.
  std::size_t search(std::deque<std::size_t> queue, std::vector<std::size_t>& before) const {
    while (!queue.empty()) {
      const std::size_t at = queue.front();
      queue.pop_front();
      for (int side = 0; side < 4; ++side) {
        const std::size_t next = at + step(side);
        if (is_border(next) || cells_[next] == kBox || before[next] != kNone) continue;
        before[next] = at;
        if (cells_[next] == kArea) return next;
        queue.push_back(next);
      }
    }
    return kNone;
  }

  void fill_holes() {
    std::vector<bool> seen(cells_.size(), false);
    for (std::size_t start = 0; start < cells_.size(); ++start) {
      if (cells_[start] == kArea || seen[start]) continue;
      std::vector<std::size_t> found{start};
      seen[start] = true;
      bool keeps = start == 0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        keeps = keeps || cells_[found[i]] == kBox;
        visit_around(found[i], [&](std::size_t next) {
          if (cells_[next] == kArea || seen[next]) return;
          seen[next] = true;
          found.push_back(next);
        });
      }
      if (keeps) continue;
      for (const std::size_t at : found) cells_[at] = kArea;
    }
  }

  // All eight neighbours.
  template <class Take>
  void visit_around(std::size_t at, const Take& take) const {
    const auto column = static_cast<std::ptrdiff_t>(at % columns_);
    const auto row = static_cast<std::ptrdiff_t>(at / columns_);
    for (std::ptrdiff_t r = row - 1; r <= row + 1; ++r) {
      for (std::ptrdiff_t c = column - 1; c <= column + 1; ++c) {
        const bool within = r >= 0 && c >= 0 && r < static_cast<std::ptrdiff_t>(rows_) &&
                            c < static_cast<std::ptrdiff_t>(columns_);
        if (within) take(static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c));
      }
    }
  }

  // At the lower left corner of a cell.
  bool fill_corner(std::size_t column, std::size_t row) {
    const std::size_t here = row * columns_ + column;
    const std::size_t left = here - 1;
    const std::size_t below = here - columns_;
    const std::size_t across = below - 1;
    const auto is = [&](std::size_t at) { return cells_[at] == kArea; };
    if (is(here) != is(across) || is(left) != is(below) || is(here) == is(left)) return false;
    for (const std::size_t at : {here, left, below, across}) {
      if (cells_[at] != kFree || is_border(at)) continue;
      cells_[at] = kArea;
      return true;
    }
    return false;
  }

  // The corner of a cell at which one of its sides begins.
  Vec2 corner(std::size_t at, int side) const {
    const std::size_t column = at % columns_;
    const std::size_t row = at / columns_;
    const bool right = side == 1 || side == 2;
    const bool top = side == 2 || side == 3;
    return {x_[right ? column : column - 1], y_[top ? row : row - 1]};
  }

  // Where two cells of the area touch at a corner, a ring turns within its own cell.
  Vec2 nudged(std::size_t at, int side) const {
    const Vec2 here = corner(at, side);
    const Vec2 middle = 0.5 * (corner(at, 0) + corner(at, 2));
    const Vec2 way = middle - here;
    const Vec2 by = (0.5 * way.cwiseAbs()).cwiseMin(kNudge);
    return here + Vec2(way.x() > 0 ? by.x() : -by.x(), way.y() > 0 ? by.y() : -by.y());
  }

  // Along the sides beyond which the area ends, the area to the left.
  std::vector<Vec2> trace(std::size_t at, int side, std::vector<std::array<bool, 4>>& seen) const {
    std::vector<Vec2> ring;
    const std::size_t first = at;
    const int first_side = side;
    do {
      seen[at][side] = true;
      const int next_side = (side + 1) % 4;
      const std::size_t ahead = at + step(next_side);
      const std::size_t beyond = ahead + step(side);
      if (cells_[ahead] != kArea) {  // around its own corner
        const bool touches = cells_[beyond] == kArea;
        ring.push_back(touches ? nudged(at, next_side) : corner(at, next_side));
        side = next_side;
      } else if (cells_[beyond] != kArea) {  // straight on
        at = ahead;
      } else {  // around the corner of what is beyond
        ring.push_back(corner(at, next_side));
        at = beyond;
        side = (side + 3) % 4;
      }
    } while (at != first || side != first_side);
    return ring;
  }

  static double area_of(const std::vector<Vec2>& ring) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      area += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    }
    return area;
  }

  std::vector<double> x_;
  std::vector<double> y_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace

std::optional<AreaRings> rings_between(std::span<const Outline> inside,
                                       std::span<const PlanBox> outside, const PlanBox& bounds) {
  std::vector<double> x = cuts(outside, bounds, 0);
  std::vector<double> y = cuts(outside, bounds, 1);
  if (x.size() * y.size() > kMostCells) return std::nullopt;
  Cells cells(std::move(x), std::move(y), outside);
  for (const Outline& region : inside) {
    if (!cells.add(region)) return std::nullopt;
  }
  if (!cells.join()) return std::nullopt;
  cells.fill();
  return cells.rings();
}

}  // namespace traj
