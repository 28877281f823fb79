#include "geom/cloud/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "geom/shape/aabb.h"

namespace geom {
namespace {

using Key = std::array<std::int64_t, 3>;

bool before(const Key& a, const Key& b) {
  if (a[0] != b[0]) return a[0] < b[0];
  return a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

// A stretch of the points in the order of their cells.
struct Part {
  std::size_t first;
  std::size_t last;

  std::size_t size() const { return last - first; }
};

struct Cell {
  Key key;
  Part part;
  Aabb box;  // around its points
};

class Linker {
 public:
  Linker(std::span<const Vec3> points, double tolerance)
      : points_(points),
        square_(tolerance * tolerance),
        // The diagonal of a cell is shorter than the tolerance, rounding included.
        side_(tolerance / std::sqrt(3.0) * (1 - 1e-6)),
        cell_at_(points.size()) {
    order_.reserve(points.size());
    sort_into_cells();
    parent_.resize(cells_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    link_cells();
  }

  std::vector<std::vector<std::size_t>> groups() {
    std::vector<std::size_t> number(cells_.size(), 0);  // of the group of a root, and 1
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::size_t& n = number[root(cell_at_[i])];
      if (n == 0) {
        out.emplace_back();
        n = out.size();
      }
      out[n - 1].push_back(i);
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return out;
  }

 private:
  Key cell_of(const Vec3& p) const {
    Key key;
    for (int i = 0; i < 3; ++i) {
      key[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / side_));
    }
    return key;
  }

  void sort_into_cells() {
    struct Placed {
      Key key;
      std::size_t point;
    };
    std::vector<Placed> placed;
    placed.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) placed.push_back({cell_of(points_[i]), i});
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      return before(a.key, b.key) || (!before(b.key, a.key) && a.point < b.point);
    });
    for (const Placed& p : placed) {
      const Vec3& at = points_[p.point];
      if (cells_.empty() || cells_.back().key != p.key) {
        cells_.push_back({p.key, {order_.size(), order_.size()}, {at, at}});
      }
      Cell& cell = cells_.back();
      cell_at_[p.point] = cells_.size() - 1;
      order_.push_back(p.point);
      ++cell.part.last;
      cell.box = {cell.box.min.cwiseMin(at), cell.box.max.cwiseMax(at)};
    }
  }

  // Cells more than two apart along an axis are further apart than the tolerance. Each pair is
  // looked at once, from the one that comes first. The neighbours in one row follow each other, and
  // the rows beside all cells in their order begin where that of the cell before did, or later.
  void link_cells() {
    constexpr std::size_t kHere = 2;      // of a row of 5 x 5: that of the cell itself
    std::array<std::size_t, 13> begin{};  // of the row in this direction
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const Key& here = cells_[c].key;
      for (std::size_t row = 0; row < begin.size(); ++row) {
        const auto beside = static_cast<std::int64_t>(row + kHere);
        const Key there{here[0] + beside / 5, here[1] + beside % 5 - 2, here[2]};
        std::size_t& at = begin[row];
        while (at < cells_.size() && before(cells_[at].key, {there[0], there[1], there[2] - 2})) {
          ++at;
        }
        if (row == 0) at = std::max(at, c + 1);
        for (std::size_t k = at; k < cells_.size(); ++k) {
          if (before({there[0], there[1], there[2] + 2}, cells_[k].key)) break;
          link(c, k);
        }
      }
    }
  }

  void link(std::size_t i, std::size_t k) {
    const std::size_t a = root(i);
    const std::size_t b = root(k);
    if (a == b || distance_square(cells_[i].box, cells_[k].box) > square_) return;
    if (have_link(cells_[i].part, cells_[k].part)) parent_[std::max(a, b)] = std::min(a, b);
  }

  bool linked(const Part& a, const Part& b) {
    return distance_square(box(a), box(b)) <= square_ && have_link(a, b);
  }

  // Whether a point of one is near one of the other, whose boxes are. Halves both until it shows:
  // boxes too far apart hold no such pair.
  bool have_link(Part a, Part b) {
    constexpr std::size_t kFew = 64;  // pairs
    if (a.size() * b.size() <= kFew) return linked_one_by_one(a, b);
    if (a.size() < b.size()) std::swap(a, b);
    const std::size_t middle = a.first + a.size() / 2;
    halve(a, middle);
    return linked({a.first, middle}, b) || linked({middle, a.last}, b);
  }

  bool linked_one_by_one(const Part& a, const Part& b) const {
    for (std::size_t i = a.first; i < a.last; ++i) {
      for (std::size_t k = b.first; k < b.last; ++k) {
        if ((points_[order_[i]] - points_[order_[k]]).squaredNorm() <= square_) return true;
      }
    }
    return false;
  }

  Aabb box(const Part& part) const {
    const Vec3& first = points_[order_[part.first]];
    Aabb out{first, first};
    for (std::size_t i = part.first + 1; i < part.last; ++i) {
      out.min = out.min.cwiseMin(points_[order_[i]]);
      out.max = out.max.cwiseMax(points_[order_[i]]);
    }
    return out;
  }

  // A little less than it is, so that no rounding hides a pair.
  static double distance_square(const Aabb& a, const Aabb& b) {
    const Vec3 gap = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0);
    return gap.squaredNorm() * (1 - 1e-12);
  }

  // By the longest axis of its box. Ties by index: the same halves each time.
  void halve(const Part& part, std::size_t middle) {
    Eigen::Index axis = 0;
    const Aabb around = box(part);
    (around.max - around.min).maxCoeff(&axis);
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(part.first), at(middle), at(part.last), [&](std::size_t a, std::size_t b) {
      const double x = points_[a][axis];
      const double y = points_[b][axis];
      return x != y ? x < y : a < b;
    });
  }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::span<const Vec3> points_;
  double square_;
  double side_;
  std::vector<std::size_t> order_;    // the points, by their cells
  std::vector<Cell> cells_;           // by their keys
  std::vector<std::size_t> cell_at_;  // of each point
  std::vector<std::size_t> parent_;   // of each cell, one linked to it
};

}  // namespace

std::vector<std::vector<std::size_t>> clusters(std::span<const Vec3> points, double tolerance) {
  return Linker(points, tolerance).groups();
}

}  // namespace geom
