#include "geom/cloud/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "geom/shape/aabb.h"

namespace geom {
namespace {

using Key = std::array<std::int64_t, 3>;

struct KeyHash {
  std::size_t operator()(const Key& k) const {
    std::uint64_t h = 0;
    for (const std::int64_t v : k) {
      h = (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

// A stretch of the points in the order of their cells.
struct Part {
  std::size_t first;
  std::size_t last;

  std::size_t size() const { return last - first; }
};

class Linker {
 public:
  Linker(std::span<const Vec3> points, double tolerance)
      : points_(points),
        square_(tolerance * tolerance),
        // The diagonal of a cell is shorter than the tolerance, rounding included.
        side_(tolerance / std::sqrt(3.0) * (1 - 1e-6)),
        order_(points.size()),
        parent_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    sort_into_cells();
    link_cells();
  }

  std::vector<std::vector<std::size_t>> groups() {
    std::vector<std::size_t> number(points_.size(), 0);  // of the group of a root, and 1
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::size_t& n = number[root(i)];
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
    std::vector<Key> keys;
    keys.reserve(points_.size());
    for (const Vec3& p : points_) keys.push_back(cell_of(p));
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
    });
    for (std::size_t i = 0; i < order_.size();) {
      std::size_t end = i + 1;
      while (end < order_.size() && keys[order_[end]] == keys[order_[i]]) ++end;
      cell_at_.emplace(keys[order_[i]], cells_.size());
      cells_.push_back({i, end});
      for (std::size_t k = i + 1; k < end; ++k) unite(order_[i], order_[k]);
      i = end;
    }
  }

  // Cells more than two apart along an axis are further apart than the tolerance.
  void link_cells() {
    for (const Part& part : cells_) {
      const Key here = cell_of(points_[order_[part.first]]);
      for (int i = 63; i < 125; ++i) {  // half of the 5 x 5 x 5 around it: each pair once
        const Key there{here[0] + i / 25 - 2, here[1] + i / 5 % 5 - 2, here[2] + i % 5 - 2};
        const auto found = cell_at_.find(there);
        if (found == cell_at_.end()) continue;
        const Part& other = cells_[found->second];
        if (root(order_[part.first]) == root(order_[other.first])) continue;
        if (linked(part, other)) unite(order_[part.first], order_[other.first]);
      }
    }
  }

  // Whether a point of one is near one of the other. Halves both until it shows: boxes too far
  // apart hold no such pair.
  bool linked(Part a, Part b) {
    constexpr std::size_t kFew = 64;  // pairs
    if (distance_square(box(a), box(b)) > square_) return false;
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
  void unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::span<const Vec3> points_;
  double square_;
  double side_;
  std::vector<std::size_t> order_;
  std::vector<std::size_t> parent_;
  std::vector<Part> cells_;
  std::unordered_map<Key, std::size_t, KeyHash> cell_at_;
};

}  // namespace

std::vector<std::vector<std::size_t>> clusters(std::span<const Vec3> points, double tolerance) {
  return Linker(points, tolerance).groups();
}

}  // namespace geom
