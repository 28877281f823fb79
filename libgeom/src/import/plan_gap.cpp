#include "import/plan_gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "geom/shape/aabb.h"
#include "geom/shape/polygon.h"

namespace geom {
namespace {

constexpr double kShare = 1.0 / 7;  // of the plan's length: the widest sliver of a small one
constexpr double kMostRows = 1e5;

// Points of a square grid, [first, last] of a row.
struct Run {
  int row;
  int first;
  int last;
};

// The points of a square grid that lie within surfaces, seen from above.
class GridPoints {
 public:
  GridPoints(const Vec2& corner, double step) : corner_(corner), step_(step) {}

  std::vector<Run> within(const CitySurfaces& surfaces, int rows) {
    runs_.clear();
    for (const CitySurface* surface : surfaces) add(*surface, rows);
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
      return a.row != b.row ? a.row < b.row : a.first < b.first;
    });
    std::vector<Run> joined;
    for (const Run& run : runs_) {
      if (!joined.empty() && joined.back().row == run.row && run.first <= joined.back().last + 1) {
        joined.back().last = std::max(joined.back().last, run.last);
      } else {
        joined.push_back(run);
      }
    }
    return joined;
  }

 private:
  struct Crossing {
    int row;
    double column;
  };

  void add(const CitySurface& surface, int rows) {
    crossings_.clear();
    for (const auto& ring : surface) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        cross(grid(ring[i]), grid(ring[(i + 1) % ring.size()]), rows);
      }
    }
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return a.row != b.row ? a.row < b.row : a.column < b.column;
    });
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const auto first = static_cast<int>(std::ceil(crossings_[i].column));
      const auto last = static_cast<int>(std::floor(crossings_[i + 1].column));
      if (first <= last) runs_.push_back({crossings_[i].row, first, last});
    }
  }

  Vec2 grid(const Vec3& p) const { return (p.head<2>() - corner_) / step_; }

  // The rows from the lower end on, without that of the upper end: each ring has two of a row.
  void cross(const Vec2& a, const Vec2& b, int rows) {
    if (a.y() == b.y()) return;
    const double last = std::min(std::ceil(std::max(a.y(), b.y())) - 1, rows - 1.0);
    for (double row = std::max(0.0, std::ceil(std::min(a.y(), b.y()))); row <= last; ++row) {
      const double column = a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      crossings_.push_back({static_cast<int>(row), std::clamp(column, -2e9, 2e9)});
    }
  }

  Vec2 corner_;
  double step_;
  std::vector<Run> runs_;
  std::vector<Crossing> crossings_;
};

// What `taken` leaves of `runs`, both in order.
std::vector<Run> left_of(const std::vector<Run>& runs, const std::vector<Run>& taken) {
  std::vector<Run> left;
  std::size_t at = 0;
  for (Run run : runs) {
    const auto before = [&](const Run& t) {
      return t.row < run.row || (t.row == run.row && t.last < run.first);
    };
    while (at < taken.size() && before(taken[at])) ++at;
    for (std::size_t i = at;
         i < taken.size() && taken[i].row == run.row && taken[i].first <= run.last; ++i) {
      if (run.first < taken[i].first) left.push_back({run.row, run.first, taken[i].first - 1});
      run.first = taken[i].last + 1;
    }
    if (run.first <= run.last) left.push_back(run);
  }
  return left;
}

// Whether two rows that follow each other have two columns in common.
bool has_square(const std::vector<Run>& runs) {
  std::size_t at = 0;
  for (const Run& upper : runs) {
    while (at < runs.size() && (runs[at].row < upper.row - 1 ||
                                (runs[at].row == upper.row - 1 && runs[at].last <= upper.first))) {
      ++at;
    }
    for (std::size_t i = at;
         i < runs.size() && runs[i].row == upper.row - 1 && runs[i].first < upper.last; ++i) {
      if (std::min(runs[i].last, upper.last) > std::max(runs[i].first, upper.first)) return true;
    }
  }
  return false;
}

std::optional<Aabb> box_of(const CitySurfaces& surfaces) {
  std::optional<Aabb> box;
  for (const CitySurface* surface : surfaces) {
    for (const auto& ring : *surface) {
      const auto around = bounds(std::span<const Vec3>(ring));
      if (around) box = box ? merged(*box, *around) : *around;
    }
  }
  return box;
}

}  // namespace

bool has_gap(const CitySurfaces& plan, const CitySurfaces& surfaces) {
  const auto box = box_of(plan);
  if (!box) return false;
  const Vec3 size = box->max - box->min;
  const double length = std::max(size.x(), size.y());
  if (!(length > 0)) return false;
  // A circle of 1.415 steps about any place has four points of a square of the grid in it.
  const double step = std::min(kWidestSliver, length * kShare) / 2 / (std::numbers::sqrt2 * 1.001);
  if (length > kMostRows * step) return true;  // longer than any building
  const auto rows = static_cast<int>(size.y() / step) + 2;
  GridPoints points(box->min.head<2>(), step);
  const std::vector<Run> shown = points.within(plan, rows);
  return has_square(left_of(shown, points.within(surfaces, rows)));
}

}  // namespace geom
