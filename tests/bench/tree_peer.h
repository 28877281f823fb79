#pragma once

// A plain tree of eight children a node beside the collision structure: single precision, AVX2,
// split at the median of the longest side, each candidate decided in double by the functions of
// geom.

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geom/base/rounding.h"
#include "geom/collision/collision.h"

namespace bench {

using geom::Aabb;
using geom::Vec3;

class TreePeer {
 public:
  explicit TreePeer(std::span<const Aabb> boxes) : boxes_(boxes), order_(boxes.size()) {
    const Aabb all = *geom::bounds(boxes);
    corner_ = all.min;
    pad_ = std::max(1e-3, std::ldexp((all.max - all.min).maxCoeff(), -20));
    std::iota(order_.begin(), order_.end(), 0u);
    add_node(0, order_.size());
  }

  [[gnu::target("avx2")]] bool hits(const Vec3& a, const Vec3& b) const {
    const Eigen::Vector3f from = (a - corner_).cast<float>();
    Eigen::Vector3f along = (b - a).cast<float>();
    for (float& d : along) d = std::abs(d) < 1e-12f ? 1e-12f : d;
    const Eigen::Vector3f inverse = along.cwiseInverse();
    std::array<std::uint32_t, 256> open;
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
      const Node& node = nodes_[next];
      __m256 first = _mm256_setzero_ps();
      __m256 last = _mm256_set1_ps(1);
      for (int i = 0; i < 3; ++i) {
        const int enter = inverse[i] < 0 ? i + 3 : i;
        const int leave = inverse[i] < 0 ? i : i + 3;
        const __m256 origin = _mm256_set1_ps(from[i]);
        const __m256 scale = _mm256_set1_ps(inverse[i]);
        first = _mm256_max_ps(
            first, _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(node.plane[enter]), origin), scale));
        last = _mm256_min_ps(
            last, _mm256_mul_ps(_mm256_sub_ps(_mm256_load_ps(node.plane[leave]), origin), scale));
      }
      auto left = static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(first, last, _CMP_LE_OQ)));
      for (; left != 0; left &= left - 1) {
        const std::uint32_t child = node.child[std::countr_zero(left)];
        if ((child & kBox) == 0) {
          open[count++] = child;
        } else if (geom::segment_hits(a, b, boxes_[child & ~kBox])) {
          return true;
        }
      }
      if (count == 0) return false;
      next = open[--count];
    }
  }

  [[gnu::target("avx2")]] double nearest(const Vec3& p) const {
    const Eigen::Vector3f at = (p - corner_).cast<float>();
    double best = std::numeric_limits<double>::infinity();
    float limit = std::numeric_limits<float>::infinity();
    struct Open {
      float square;
      std::uint32_t node;
    };
    std::array<Open, 256> open;
    std::size_t count = 0;
    Open next{0, 0};
    for (;;) {
      const Node& node = nodes_[next.node];
      __m256 sum = _mm256_setzero_ps();
      for (int i = 0; i < 3; ++i) {
        const __m256 origin = _mm256_set1_ps(at[i]);
        const __m256 off =
            _mm256_max_ps(_mm256_max_ps(_mm256_sub_ps(_mm256_load_ps(node.plane[i]), origin),
                                        _mm256_sub_ps(origin, _mm256_load_ps(node.plane[i + 3]))),
                          _mm256_setzero_ps());
        sum = _mm256_add_ps(sum, _mm256_mul_ps(off, off));
      }
      alignas(32) std::array<float, 8> square;
      _mm256_store_ps(square.data(), sum);
      auto left = static_cast<unsigned>(
          _mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_set1_ps(limit), _CMP_LE_OQ)));
      const std::size_t before = count;
      for (; left != 0; left &= left - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t child = node.child[k];
        if (square[k] > limit || child == kNone) continue;
        if ((child & kBox) != 0) {
          const double distance = geom::distance(p, boxes_[child & ~kBox]);
          if (distance >= best) continue;
          best = distance;
          limit = geom::float_up((best + 2 * pad_) * (best + 2 * pad_));
          continue;
        }
        std::size_t k2 = count++;
        for (; k2 > before && open[k2 - 1].square < square[k]; --k2) open[k2] = open[k2 - 1];
        open[k2] = {square[k], child};
      }
      do {
        if (count == 0) return best;
        next = open[--count];
      } while (next.square > limit);
    }
  }

  [[gnu::target("avx2")]] std::vector<std::size_t> boxes_meeting(const Aabb& region) const {
    const Eigen::Vector3f low = (region.min - corner_).cast<float>();
    const Eigen::Vector3f high = (region.max - corner_).cast<float>();
    std::vector<std::size_t> found;
    std::array<std::uint32_t, 256> open;
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
      const Node& node = nodes_[next];
      __m256 meets = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
      for (int i = 0; i < 3; ++i) {
        meets = _mm256_and_ps(meets, _mm256_cmp_ps(_mm256_load_ps(node.plane[i]),
                                                   _mm256_set1_ps(high[i]), _CMP_LE_OQ));
        meets = _mm256_and_ps(meets, _mm256_cmp_ps(_mm256_load_ps(node.plane[i + 3]),
                                                   _mm256_set1_ps(low[i]), _CMP_GE_OQ));
      }
      auto left = static_cast<unsigned>(_mm256_movemask_ps(meets));
      for (; left != 0; left &= left - 1) {
        const std::uint32_t child = node.child[std::countr_zero(left)];
        if ((child & kBox) == 0) {
          open[count++] = child;
        } else if (geom::overlap(region, boxes_[child & ~kBox])) {
          found.push_back(child & ~kBox);
        }
      }
      if (count == 0) break;
      next = open[--count];
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static constexpr std::uint32_t kBox = 0x80000000;
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct alignas(64) Node {
    float plane[6][8];
    std::uint32_t child[8];
  };

  Aabb bounds_of(std::size_t begin, std::size_t end) const {
    Aabb all = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) all = geom::merged(all, boxes_[order_[i]]);
    return all;
  }

  std::uint32_t add_node(std::size_t begin, std::size_t end) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    std::vector<std::pair<std::size_t, std::size_t>> parts{{begin, end}};
    while (parts.size() < 8) {
      const auto largest = std::max_element(
          parts.begin(), parts.end(),
          [](const auto& x, const auto& y) { return x.second - x.first < y.second - y.first; });
      const auto [from, to] = *largest;
      if (to - from < 2 || (end - begin > 8 && to - from <= 8)) break;
      const std::size_t middle = split(from, to);
      *largest = {from, middle};
      parts.emplace_back(middle, to);
    }
    for (std::size_t k = 0; k < 8; ++k) {
      float planes[6] = {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};
      std::uint32_t child = kNone;
      if (k < parts.size()) {
        const auto [from, to] = parts[k];
        const Aabb all = bounds_of(from, to);
        for (int i = 0; i < 3; ++i) {
          planes[i] = geom::float_down(all.min[i] - corner_[i] - pad_);
          planes[i + 3] = geom::float_up(all.max[i] - corner_[i] + pad_);
        }
        child = to - from == 1 ? order_[from] | kBox : add_node(from, to);
      }
      Node& node = nodes_[place];
      for (int i = 0; i < 6; ++i) node.plane[i][k] = planes[i];
      node.child[k] = child;
    }
    return place;
  }

  std::size_t split(std::size_t from, std::size_t to) {
    const Aabb all = bounds_of(from, to);
    int axis = 0;
    (all.max - all.min).maxCoeff(&axis);
    const std::size_t middle = (from + to) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(from), at(middle), at(to), [&](std::uint32_t x, std::uint32_t y) {
      return boxes_[x].min[axis] + boxes_[x].max[axis] < boxes_[y].min[axis] + boxes_[y].max[axis];
    });
    return middle;
  }

  std::span<const Aabb> boxes_;
  std::vector<std::uint32_t> order_;
  Vec3 corner_;
  double pad_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace bench
