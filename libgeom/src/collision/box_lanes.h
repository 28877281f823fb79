#pragma once

// What is asked of the sixteen children of a node at once, with AVX-512 or AVX2 where the processor
// has it. Roundings differ between these, and so do candidates; answers never do, since who asks
// decides each candidate in double.

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "box_tree.h"
#include "geom/base/rounding.h"

namespace geom {

// A segment in the frame of a tree. The slab test: Kay and Kajiya 1986.
struct SegmentInTree {
  static constexpr std::uint32_t kPlane = BoxNode::kLanes;  // numbers in a plane

  std::array<std::uint32_t, 3> enter;  // the plane where the segment comes into a box, as the
                                       // offset of its first number,
  std::array<std::uint32_t, 3> leave;  // and where it goes out
  std::array<float, 3> inverse;        // of b - a
  std::array<float, 3> start;          // -a times that
  bool outside = false;                // beyond all boxes

  SegmentInTree(const TreeFrame& frame, const Vec3& a, const Vec3& b) {
    if (contains(frame.reach, a) && contains(frame.reach, b)) {
      set(frame, a, b);
      return;
    }
    const auto near = clip(a, b, frame.reach);
    outside = !near.has_value();
    if (near) set(frame, a + (b - a) * near->from, a + (b - a) * near->to);
  }

 private:
  // Without branches: directions are random.
  void set(const TreeFrame& frame, const Vec3& a, const Vec3& b) {
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::uint32_t>(i);
      const auto along = static_cast<float>(b[i] - a[i]);
      const std::uint32_t back = std::bit_cast<std::uint32_t>(along) >> 31;
      enter[k] = kPlane * (k + 3 * back);
      leave[k] = kPlane * (k + 3 * (1 - back));
      // A shorter way along an axis is within the pad, and its inverse stays finite.
      inverse[k] = 1 / std::copysign(std::max(std::abs(along), 1e-9f), along);
      start[k] = -static_cast<float>(a[i] - frame.corner[i]) * inverse[k];
    }
  }
};

// A region in the frame of a tree, outward. It may be infinite.
struct RegionInTree {
  std::array<float, 3> low;
  std::array<float, 3> high;

  RegionInTree(const TreeFrame& frame, const Aabb& region) {
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      low[k] = float_down(std::max(region.min[i], frame.reach.min[i]) - frame.corner[i]);
      high[k] = float_up(std::min(region.max[i], frame.reach.max[i]) - frame.corner[i]);
    }
  }
};

// A point in the frame of a tree.
struct PointInTree {
  std::array<float, 3> at;
  double slack = 0;  // what single precision may lose far outside, in metres

  PointInTree(const TreeFrame& frame, const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
      const double place = p[i] - frame.corner[i];
      at[static_cast<std::size_t>(i)] = static_cast<float>(place);
      slack = std::max(slack, std::ldexp(std::abs(place), -22));
    }
  }

  // Whoever is within `radius` has a computed square no larger: the few roundings of it are within
  // a millionth.
  float limit(double radius) const {
    const double r = radius + slack;
    const double square = r * r * (1 + 1e-6);
    return square < FLT_MAX ? float_up(square) : std::numeric_limits<float>::infinity();
  }
};

// Each kind of processor answers the same four questions. on, in, near: bit k says whether child k
// may meet what is asked for; near writes out the squares of the distances too, and nearest is the
// child where that is least. push puts the children of a mask on a stack of which kLanes more
// numbers may be overwritten, and returns how many.
namespace lanes {

struct Plain {
  static constexpr bool usable() { return true; }

  static unsigned on(const BoxNode& node, const SegmentInTree& s) {
    const float* const planes = &node.plane[0][0];
    unsigned out = 0;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      float first = 0;
      float last = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        first = std::max(first, planes[s.enter[i] + k] * s.inverse[i] + s.start[i]);
        last = std::min(last, planes[s.leave[i] + k] * s.inverse[i] + s.start[i]);
      }
      out |= static_cast<unsigned>(first <= last) << k;
    }
    return out;
  }

  static unsigned in(const BoxNode& node, const RegionInTree& r) {
    unsigned out = 0;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      bool together = true;
      for (std::size_t i = 0; i < 3; ++i) {
        together &= node.plane[i][k] <= r.high[i] && r.low[i] <= node.plane[3 + i][k];
      }
      out |= static_cast<unsigned>(together) << k;
    }
    return out;
  }

  static float square_of(const BoxNode& node, const PointInTree& p, std::size_t k) {
    float sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const float off =
          std::max(std::max(node.plane[i][k] - p.at[i], p.at[i] - node.plane[3 + i][k]), 0.0f);
      sum += off * off;
    }
    return sum;
  }

  static unsigned near(const BoxNode& node, const PointInTree& p, float limit, float* squares) {
    unsigned out = 0;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      squares[k] = square_of(node, p, k);
      out |= static_cast<unsigned>(squares[k] <= limit && node.child[k] != BoxNode::kNone) << k;
    }
    return out;
  }

  static unsigned nearest(const BoxNode& node, const PointInTree& p) {
    unsigned least = 0;
    for (unsigned k = 1; k < BoxNode::kLanes; ++k) {
      if (square_of(node, p, k) < square_of(node, p, least)) least = k;
    }
    return least;
  }

  static std::size_t push(const BoxNode& node, unsigned mask, std::uint32_t* open) {
    std::size_t count = 0;
    for (; mask != 0; mask &= mask - 1) open[count++] = node.child[std::countr_zero(mask)];
    return count;
  }
};

#if defined(__x86_64__)
#define SKYWAY_AVX2 [[gnu::target("avx2,fma,popcnt,bmi")]]
#define SKYWAY_AVX512 [[gnu::target("avx512f,avx2,fma,popcnt,bmi")]]

// Of each mask of eight, which lanes it has, one a byte.
inline constexpr auto kPicked = [] {
  std::array<std::uint64_t, 256> out{};
  for (unsigned mask = 0; mask < 256; ++mask) {
    unsigned count = 0;
    for (std::uint64_t lane = 0; lane < 8; ++lane) {
      if ((mask >> lane & 1) != 0) out[mask] |= lane << (8 * count++);
    }
  }
  return out;
}();

struct Avx2 {
  static bool usable() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
  }

  SKYWAY_AVX2 static __m256 place(const float* plane, const SegmentInTree& s, std::size_t i) {
    return _mm256_fmadd_ps(_mm256_load_ps(plane), _mm256_set1_ps(s.inverse[i]),
                           _mm256_set1_ps(s.start[i]));
  }

  SKYWAY_AVX2 static unsigned on(const BoxNode& node, const SegmentInTree& s) {
    unsigned out = 0;
#pragma GCC unroll 2
    for (std::size_t half = 0; half < BoxNode::kLanes; half += 8) {
      const float* const planes = &node.plane[0][half];
      const __m256 first = _mm256_max_ps(
          _mm256_max_ps(place(planes + s.enter[0], s, 0), place(planes + s.enter[1], s, 1)),
          _mm256_max_ps(place(planes + s.enter[2], s, 2), _mm256_setzero_ps()));
      const __m256 last = _mm256_min_ps(
          _mm256_min_ps(place(planes + s.leave[0], s, 0), place(planes + s.leave[1], s, 1)),
          _mm256_min_ps(place(planes + s.leave[2], s, 2), _mm256_set1_ps(1)));
      out |= static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(first, last, _CMP_LE_OQ)))
             << half;
    }
    return out;
  }

  SKYWAY_AVX2 static unsigned in(const BoxNode& node, const RegionInTree& r) {
    unsigned out = 0;
    for (std::size_t half = 0; half < BoxNode::kLanes; half += 8) {
      __m256 together = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
#pragma GCC unroll 3
      for (std::size_t i = 0; i < 3; ++i) {
        const __m256 low = _mm256_load_ps(&node.plane[i][half]);
        const __m256 high = _mm256_load_ps(&node.plane[3 + i][half]);
        together =
            _mm256_and_ps(together, _mm256_cmp_ps(low, _mm256_set1_ps(r.high[i]), _CMP_LE_OQ));
        together =
            _mm256_and_ps(together, _mm256_cmp_ps(high, _mm256_set1_ps(r.low[i]), _CMP_GE_OQ));
      }
      out |= static_cast<unsigned>(_mm256_movemask_ps(together)) << half;
    }
    return out;
  }

  SKYWAY_AVX2 static __m256 squares_of(const BoxNode& node, const PointInTree& p,
                                       std::size_t half) {
    __m256 sum = _mm256_setzero_ps();
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const __m256 at = _mm256_set1_ps(p.at[i]);
      const __m256 below = _mm256_sub_ps(_mm256_load_ps(&node.plane[i][half]), at);
      const __m256 above = _mm256_sub_ps(at, _mm256_load_ps(&node.plane[3 + i][half]));
      const __m256 off = _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
      sum = _mm256_fmadd_ps(off, off, sum);
    }
    return sum;
  }

  SKYWAY_AVX2 static unsigned near(const BoxNode& node, const PointInTree& p, float limit,
                                   float* squares) {
    unsigned out = 0;
#pragma GCC unroll 2
    for (std::size_t half = 0; half < BoxNode::kLanes; half += 8) {
      const __m256 sum = squares_of(node, p, half);
      _mm256_storeu_ps(squares + half, sum);
      const __m256 none = _mm256_castsi256_ps(
          _mm256_cmpeq_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(node.child + half)),
                             _mm256_set1_epi32(-1)));
      const __m256 close = _mm256_cmp_ps(sum, _mm256_set1_ps(limit), _CMP_LE_OQ);
      out |= static_cast<unsigned>(_mm256_movemask_ps(_mm256_andnot_ps(none, close))) << half;
    }
    return out;
  }

  SKYWAY_AVX2 static unsigned nearest(const BoxNode& node, const PointInTree& p) {
    const __m256 low = squares_of(node, p, 0);
    const __m256 high = squares_of(node, p, 8);
    __m256 least = _mm256_min_ps(low, high);
    least = _mm256_min_ps(least, _mm256_permute2f128_ps(least, least, 1));
    least = _mm256_min_ps(least, _mm256_permute_ps(least, 0x4e));
    least = _mm256_min_ps(least, _mm256_permute_ps(least, 0xb1));
    const int first = _mm256_movemask_ps(_mm256_cmp_ps(low, least, _CMP_EQ_OQ));
    const int second = _mm256_movemask_ps(_mm256_cmp_ps(high, least, _CMP_EQ_OQ));
    return static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(first | second << 8)));
  }

  SKYWAY_AVX2 static std::size_t push(const BoxNode& node, unsigned mask, std::uint32_t* open) {
    const std::size_t first = pick(node.child, mask & 0xff, open);
    return first + pick(node.child + 8, mask >> 8, open + first);
  }

  SKYWAY_AVX2 static std::size_t pick(const std::uint32_t* from, unsigned mask, std::uint32_t* to) {
    const __m256i order =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kPicked[mask])));
    const __m256i picked = _mm256_permutevar8x32_epi32(
        _mm256_load_si256(reinterpret_cast<const __m256i*>(from)), order);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), picked);
    return static_cast<std::size_t>(std::popcount(mask));
  }
};

struct Avx512 {
  static bool usable() {
    static const bool has = __builtin_cpu_supports("avx512f") && Avx2::usable();
    return has;
  }

  // GCC 12 warns of what its own unmasked forms leave undefined on purpose.
  SKYWAY_AVX512 static __m512 max(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
  SKYWAY_AVX512 static __m512 min(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }

  SKYWAY_AVX512 static __m512 place(const float* plane, const SegmentInTree& s, std::size_t i) {
    return _mm512_fmadd_ps(_mm512_load_ps(plane), _mm512_set1_ps(s.inverse[i]),
                           _mm512_set1_ps(s.start[i]));
  }

  SKYWAY_AVX512 static unsigned on(const BoxNode& node, const SegmentInTree& s) {
    const float* const planes = &node.plane[0][0];
    const __m512 first =
        max(max(place(planes + s.enter[0], s, 0), place(planes + s.enter[1], s, 1)),
            max(place(planes + s.enter[2], s, 2), _mm512_setzero_ps()));
    const __m512 last = min(min(place(planes + s.leave[0], s, 0), place(planes + s.leave[1], s, 1)),
                            min(place(planes + s.leave[2], s, 2), _mm512_set1_ps(1)));
    return _mm512_cmp_ps_mask(first, last, _CMP_LE_OQ);
  }

  SKYWAY_AVX512 static unsigned in(const BoxNode& node, const RegionInTree& r) {
    __mmask16 together = 0xffff;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      together = _mm512_mask_cmp_ps_mask(together, _mm512_load_ps(node.plane[i]),
                                         _mm512_set1_ps(r.high[i]), _CMP_LE_OQ);
      together = _mm512_mask_cmp_ps_mask(together, _mm512_load_ps(node.plane[3 + i]),
                                         _mm512_set1_ps(r.low[i]), _CMP_GE_OQ);
    }
    return together;
  }

  SKYWAY_AVX512 static __m512 squares_of(const BoxNode& node, const PointInTree& p) {
    __m512 sum = _mm512_setzero_ps();
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const __m512 at = _mm512_set1_ps(p.at[i]);
      const __m512 below = _mm512_sub_ps(_mm512_load_ps(node.plane[i]), at);
      const __m512 above = _mm512_sub_ps(at, _mm512_load_ps(node.plane[3 + i]));
      const __m512 off = max(max(below, above), _mm512_setzero_ps());
      sum = _mm512_fmadd_ps(off, off, sum);
    }
    return sum;
  }

  SKYWAY_AVX512 static unsigned near(const BoxNode& node, const PointInTree& p, float limit,
                                     float* squares) {
    const __m512 sum = squares_of(node, p);
    _mm512_storeu_ps(squares, sum);
    const __mmask16 children =
        _mm512_cmpneq_epi32_mask(_mm512_load_si512(node.child), _mm512_set1_epi32(-1));
    return _mm512_mask_cmp_ps_mask(children, sum, _mm512_set1_ps(limit), _CMP_LE_OQ);
  }

  SKYWAY_AVX512 static unsigned nearest(const BoxNode& node, const PointInTree& p) {
    return Avx2::nearest(node, p);
  }

  SKYWAY_AVX512 static std::size_t push(const BoxNode& node, unsigned mask, std::uint32_t* open) {
    const __m512i picked =
        _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), _mm512_load_si512(node.child));
    _mm512_storeu_si512(open, picked);
    return static_cast<std::size_t>(std::popcount(mask));
  }
};
#endif

}  // namespace lanes
}  // namespace geom
