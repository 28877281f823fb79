#pragma once

// A tree of eight children a node beside the collision structure: split by the surface area
// heuristic, single precision, AVX2, each candidate decided in double by the functions of geom.

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "binned_tree.h"
#include "peer_frame.h"

namespace bench {

class TreePeer {
 public:
  explicit TreePeer(std::span<const Aabb> boxes) : frame_(boxes) {
    const BinnedTree binary(boxes, kLanes);
    name_.assign(binary.order().begin(), binary.order().end());
    boxes_.reserve(boxes.size());
    for (const std::uint32_t i : name_) boxes_.push_back(boxes[i]);
    nodes_.reserve(boxes.size() / 3);
    add_node(binary, 0);
  }

  [[gnu::target("avx2,fma")]] bool hits(const Vec3& a, const Vec3& b) const {
    const PeerSegment segment(frame_, a, b);
    int enter[3];
    int leave[3];
    __m256 scale[3];
    __m256 start[3];
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      enter[i] = segment.inverse[i] < 0 ? i + 3 : i;
      leave[i] = segment.inverse[i] < 0 ? i : i + 3;
      scale[i] = _mm256_set1_ps(segment.inverse[i]);
      start[i] = _mm256_set1_ps(-segment.from[i] * segment.inverse[i]);
    }
    std::array<std::uint32_t, kStack> open;
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
      const Node& node = nodes_[next];
      __m256 first = _mm256_setzero_ps();
      __m256 last = _mm256_set1_ps(1);
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
        const __m256 in = _mm256_load_ps(node.plane[enter[i]]);
        const __m256 out = _mm256_load_ps(node.plane[leave[i]]);
        first = _mm256_max_ps(first, _mm256_fmadd_ps(in, scale[i], start[i]));
        last = _mm256_min_ps(last, _mm256_fmadd_ps(out, scale[i], start[i]));
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
    const Eigen::Vector3f at = frame_.at(p);
    double best = std::numeric_limits<double>::infinity();
    float limit = std::numeric_limits<float>::infinity();
    std::array<Open, kStack> open;
    std::size_t count = 0;
    Open next{0, 0};
    for (;;) {
      const Node& node = nodes_[next.node];
      alignas(32) std::array<float, kLanes> square;
      auto left = near(node, at, limit, square.data());
      const std::size_t before = count;
      for (; left != 0; left &= left - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t child = node.child[k];
        if (square[k] > limit || child == kNone) continue;
        if ((child & kBox) != 0) {
          const double distance = geom::distance(p, boxes_[child & ~kBox]);
          if (distance >= best) continue;
          best = distance;
          limit = frame_.limit(best);
          continue;
        }
        std::size_t place = count++;  // the nearest on top
        for (; place > before && open[place - 1].square < square[k]; --place) {
          open[place] = open[place - 1];
        }
        open[place] = {square[k], child};
      }
      do {
        if (count == 0) return best;
        next = open[--count];
      } while (next.square > limit);
    }
  }

  [[gnu::target("avx2")]] std::vector<std::size_t> boxes_meeting(const Aabb& region) const {
    const Eigen::Vector3f low = frame_.at(region.min);
    const Eigen::Vector3f high = frame_.at(region.max);
    std::vector<std::size_t> found;
    found.reserve(kFew);
    std::array<std::uint32_t, kStack> open;
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
      const Node& node = nodes_[next];
      __m256 meets = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
#pragma GCC unroll 3
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
          found.push_back(name_[child & ~kBox]);
        }
      }
      if (count == 0) break;
      next = open[--count];
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static constexpr std::size_t kLanes = 8;
  static constexpr std::size_t kStack = 1024;
  static constexpr std::uint32_t kBox = 0x80000000;
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct alignas(64) Node {
    float plane[6][kLanes];
    std::uint32_t child[kLanes];
  };
  struct Open {
    float square;
    std::uint32_t node;
  };

  // The squares of the distances to the children, and which are not beyond a limit.
  [[gnu::target("avx2")]] static unsigned near(const Node& node, const Eigen::Vector3f& at,
                                               float limit, float* square) {
    __m256 sum = _mm256_setzero_ps();
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const __m256 origin = _mm256_set1_ps(at[i]);
      const __m256 below = _mm256_sub_ps(_mm256_load_ps(node.plane[i]), origin);
      const __m256 above = _mm256_sub_ps(origin, _mm256_load_ps(node.plane[i + 3]));
      const __m256 off = _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
      sum = _mm256_add_ps(sum, _mm256_mul_ps(off, off));
    }
    _mm256_store_ps(square, sum);
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_set1_ps(limit), _CMP_LE_OQ)));
  }

  // Of a part of the binary tree: what becomes children of one node. The largest is opened first,
  // those that fill a node by themselves before those that do not.
  static std::vector<std::uint32_t> children(const BinnedTree& binary, std::uint32_t root) {
    const auto nodes = binary.nodes();
    std::vector<std::uint32_t> out{root};
    for (;;) {
      std::size_t best = out.size();
      const auto worth = [&](std::uint32_t k) {
        const auto& node = nodes[k];
        if (node.count == 1) return -1.0;
        const bool small = node.count <= kLanes;
        if (small && out.size() + node.count - 1 > kLanes) return -1.0;
        return area(node.bounds) * (small ? 1e-12 : 1.0);
      };
      for (std::size_t k = 0; k < out.size(); ++k) {
        if (worth(out[k]) < 0 || (best < out.size() && worth(out[k]) <= worth(out[best]))) continue;
        best = k;
      }
      if (best == out.size() || out.size() == kLanes) return out;
      const std::uint32_t child = nodes[out[best]].child;
      out[best] = child;
      out.push_back(child + 1);
    }
  }

  std::uint32_t add_node(const BinnedTree& binary, std::uint32_t root) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    const auto parts = children(binary, root);
    for (std::size_t k = 0; k < kLanes; ++k) {
      float planes[6] = {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};
      std::uint32_t child = kNone;
      if (k < parts.size()) {
        const auto& part = binary.nodes()[parts[k]];
        for (int i = 0; i < 3; ++i) {
          planes[i] = frame_.low(part.bounds, i);
          planes[i + 3] = frame_.high(part.bounds, i);
        }
        child = part.count == 1 ? part.first | kBox : add_node(binary, parts[k]);
      }
      Node& node = nodes_[place];
      for (int i = 0; i < 6; ++i) node.plane[i][k] = planes[i];
      node.child[k] = child;
    }
    return place;
  }

  std::vector<Aabb> boxes_;  // from leaf to leaf
  std::vector<std::uint32_t> name_;
  PeerFrame frame_;
  std::vector<Node> nodes_;
};

}  // namespace bench
