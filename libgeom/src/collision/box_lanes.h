#pragma once

// What is asked of the sixteen children of a node at once, with AVX-512 or AVX2 where the processor
// has it. Roundings differ between these, and so do candidates; answers never do, since who asks
// decides in double what is in doubt.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#include <sys/platform/x86.h>
#endif

#include "box_tree.h"
#include "tree_questions.h"

namespace geom {

// Each kind of processor answers the same five questions. on, in, near: bit k says whether child k
// may meet what is asked for, and of on and in also whether it surely does; near writes out the
// squares of the distances too. boxes: whether it is a box, or none. push puts the children of a
// mask on a stack of which kLanes more numbers may be overwritten, and returns how many. push_near
// puts those that are near on one and their squares on another, but for the nearest.
namespace lanes {

// Of the children of a node: which may meet what is asked for, and which do, whatever roundings
// did.
struct Met {
  unsigned may = 0;
  unsigned surely = 0;
};

// Of the children of a node that are near: the nearest, or none, and how many others there are.
struct Near {
  std::uint32_t nearest = BoxNode::kNone;
  std::size_t others = 0;
};

struct Plain {
  static constexpr bool usable() { return true; }

  static Met on(const BoxNode& node, const SegmentInTree& s) {
    const float* const planes = &node.plane[0][0];
    Met out;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      float first = 0;
      float last = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        first = std::max(first, planes[s.enter[i] + k] * s.inverse[i] + s.start[i]);
        last = std::min(last, planes[s.leave[i] + k] * s.inverse[i] + s.start[i]);
      }
      out.may |= static_cast<unsigned>(first <= last) << k;
      out.surely |= static_cast<unsigned>(first + s.sure <= last) << k;
    }
    return out;
  }

  static Met in(const BoxNode& node, const RegionInTree& r) {
    Met out;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
      float most = -std::numeric_limits<float>::infinity();
      for (std::size_t i = 0; i < 3; ++i) {
        most =
            std::max(most, std::max(node.plane[i][k] - r.high[i], r.low[i] - node.plane[3 + i][k]));
      }
      out.may |= static_cast<unsigned>(most <= 0) << k;
      out.surely |= static_cast<unsigned>(most <= r.sure) << k;
    }
    return out;
  }

  static unsigned boxes(const BoxNode& node) {
    unsigned out = 0;
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) out |= node.child[k] >> 31 << k;
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

  static Near push_near(const BoxNode& node, const PointInTree& p, float limit, float* squares,
                        std::uint32_t* open) {
    std::array<float, BoxNode::kLanes> all;
    const unsigned mask = near(node, p, limit, all.data());
    if (mask == 0) return {};
    auto least = static_cast<std::size_t>(std::countr_zero(mask));
    for (std::size_t k = least + 1; k < BoxNode::kLanes; ++k) {
      if ((mask >> k & 1) != 0 && all[k] < all[least]) least = k;
    }
    const unsigned others = mask & ~(1u << least);
    std::size_t count = 0;
    for (unsigned left = others; left != 0; left &= left - 1) {
      squares[count++] = all[static_cast<std::size_t>(std::countr_zero(left))];
    }
    return {node.child[least], push(node, others, open)};
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
    static const bool has = CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA);
    return has;
  }

  SKYWAY_AVX2 static __m256 place(const float* plane, const SegmentInTree& s, std::size_t i) {
    return _mm256_fmadd_ps(_mm256_load_ps(plane), _mm256_set1_ps(s.inverse[i]),
                           _mm256_set1_ps(s.start[i]));
  }

  SKYWAY_AVX2 static unsigned at_most(__m256 a, __m256 b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)));
  }

  SKYWAY_AVX2 static Met on(const BoxNode& node, const SegmentInTree& s) {
    Met out;
#pragma GCC unroll 2
    for (std::size_t half = 0; half < BoxNode::kLanes; half += 8) {
      const float* const planes = &node.plane[0][half];
      const __m256 first = _mm256_max_ps(
          _mm256_max_ps(place(planes + s.enter[0], s, 0), place(planes + s.enter[1], s, 1)),
          _mm256_max_ps(place(planes + s.enter[2], s, 2), _mm256_setzero_ps()));
      const __m256 last = _mm256_min_ps(
          _mm256_min_ps(place(planes + s.leave[0], s, 0), place(planes + s.leave[1], s, 1)),
          _mm256_min_ps(place(planes + s.leave[2], s, 2), _mm256_set1_ps(1)));
      out.may |= at_most(first, last) << half;
      out.surely |= at_most(_mm256_add_ps(first, _mm256_set1_ps(s.sure)), last) << half;
    }
    return out;
  }

  SKYWAY_AVX2 static __m256 beside(const BoxNode& node, const RegionInTree& r, std::size_t i,
                                   std::size_t half) {
    const __m256 low = _mm256_load_ps(&node.plane[i][half]);
    const __m256 high = _mm256_load_ps(&node.plane[3 + i][half]);
    return _mm256_max_ps(_mm256_sub_ps(low, _mm256_set1_ps(r.high[i])),
                         _mm256_sub_ps(_mm256_set1_ps(r.low[i]), high));
  }

  SKYWAY_AVX2 static Met in(const BoxNode& node, const RegionInTree& r) {
    Met out;
#pragma GCC unroll 2
    for (std::size_t half = 0; half < BoxNode::kLanes; half += 8) {
      const __m256 most =
          _mm256_max_ps(_mm256_max_ps(beside(node, r, 0, half), beside(node, r, 1, half)),
                        beside(node, r, 2, half));
      out.may |= at_most(most, _mm256_setzero_ps()) << half;
      out.surely |= at_most(most, _mm256_set1_ps(r.sure)) << half;
    }
    return out;
  }

  SKYWAY_AVX2 static unsigned boxes(const BoxNode& node) {
    const auto* const signs = reinterpret_cast<const float*>(node.child);
    const int first = _mm256_movemask_ps(_mm256_load_ps(signs));
    const int second = _mm256_movemask_ps(_mm256_load_ps(signs + 8));
    return static_cast<unsigned>(first | second << 8);
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

  SKYWAY_AVX2 static Near push_near(const BoxNode& node, const PointInTree& p, float limit,
                                    float* squares, std::uint32_t* open) {
    alignas(32) std::array<float, BoxNode::kLanes> all;
    const unsigned mask = near(node, p, limit, all.data());
    if (mask == 0) return {};
    const auto least = static_cast<std::size_t>(std::countr_zero(mask & where_least(all.data())));
    const unsigned others = mask & ~(1u << least);
    pick(all.data(), others, squares);
    return {node.child[least], push(node, others, open)};
  }

  // The lanes where the numbers are least.
  SKYWAY_AVX2 static unsigned where_least(const float* numbers) {
    const __m256 low = _mm256_load_ps(numbers);
    const __m256 high = _mm256_load_ps(numbers + 8);
    __m256 least = _mm256_min_ps(low, high);
    least = _mm256_min_ps(least, _mm256_permute2f128_ps(least, least, 1));
    least = _mm256_min_ps(least, _mm256_permute_ps(least, 0x4e));
    least = _mm256_min_ps(least, _mm256_permute_ps(least, 0xb1));
    const int first = _mm256_movemask_ps(_mm256_cmp_ps(low, least, _CMP_EQ_OQ));
    const int second = _mm256_movemask_ps(_mm256_cmp_ps(high, least, _CMP_EQ_OQ));
    return static_cast<unsigned>(first | second << 8);
  }

  SKYWAY_AVX2 static std::size_t push(const BoxNode& node, unsigned mask, std::uint32_t* open) {
    return pick(node.child, mask, open);
  }

  // The numbers of a mask, one after the other.
  template <class Number>
  SKYWAY_AVX2 static std::size_t pick(const Number* from, unsigned mask, Number* to) {
    const std::size_t first = pick_of_eight(from, mask & 0xff, to);
    return first + pick_of_eight(from + 8, mask >> 8, to + first);
  }

  template <class Number>
  SKYWAY_AVX2 static std::size_t pick_of_eight(const Number* from, unsigned mask, Number* to) {
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
    static const bool has = CPU_FEATURE_ACTIVE(AVX512F) && Avx2::usable();
    return has;
  }

  // GCC 12 warns of what its own unmasked forms leave undefined on purpose.
  SKYWAY_AVX512 static __m512 max(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
  SKYWAY_AVX512 static __m512 min(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }

  SKYWAY_AVX512 static __m512 place(const float* plane, const SegmentInTree& s, std::size_t i) {
    return _mm512_fmadd_ps(_mm512_load_ps(plane), _mm512_set1_ps(s.inverse[i]),
                           _mm512_set1_ps(s.start[i]));
  }

  SKYWAY_AVX512 static Met on(const BoxNode& node, const SegmentInTree& s) {
    const float* const planes = &node.plane[0][0];
    const __m512 first =
        max(max(place(planes + s.enter[0], s, 0), place(planes + s.enter[1], s, 1)),
            max(place(planes + s.enter[2], s, 2), _mm512_setzero_ps()));
    const __m512 last = min(min(place(planes + s.leave[0], s, 0), place(planes + s.leave[1], s, 1)),
                            min(place(planes + s.leave[2], s, 2), _mm512_set1_ps(1)));
    return {_mm512_cmp_ps_mask(first, last, _CMP_LE_OQ),
            _mm512_cmp_ps_mask(_mm512_add_ps(first, _mm512_set1_ps(s.sure)), last, _CMP_LE_OQ)};
  }

  // How far beside the region, along the axis where that is most: compared once.
  SKYWAY_AVX512 static __m512 beside(const BoxNode& node, const RegionInTree& r, std::size_t i) {
    const __m512 below = _mm512_sub_ps(_mm512_load_ps(node.plane[i]), _mm512_set1_ps(r.high[i]));
    const __m512 above = _mm512_sub_ps(_mm512_set1_ps(r.low[i]), _mm512_load_ps(node.plane[3 + i]));
    return max(below, above);
  }

  SKYWAY_AVX512 static Met in(const BoxNode& node, const RegionInTree& r) {
    const __m512 most = max(max(beside(node, r, 0), beside(node, r, 1)), beside(node, r, 2));
    return {_mm512_cmp_ps_mask(most, _mm512_setzero_ps(), _CMP_LE_OQ),
            _mm512_cmp_ps_mask(most, _mm512_set1_ps(r.sure), _CMP_LE_OQ)};
  }

  SKYWAY_AVX512 static unsigned boxes(const BoxNode& node) {
    return _mm512_cmplt_epi32_mask(_mm512_load_si512(node.child), _mm512_setzero_si512());
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

  SKYWAY_AVX512 static __mmask16 near(__m512i child, __m512 squares, float limit) {
    const __mmask16 children = _mm512_cmpneq_epi32_mask(child, _mm512_set1_epi32(-1));
    return _mm512_mask_cmp_ps_mask(children, squares, _mm512_set1_ps(limit), _CMP_LE_OQ);
  }

  SKYWAY_AVX512 static unsigned near(const BoxNode& node, const PointInTree& p, float limit,
                                     float* squares) {
    const __m512 sum = squares_of(node, p);
    _mm512_storeu_ps(squares, sum);
    return near(_mm512_load_si512(node.child), sum, limit);
  }

  SKYWAY_AVX512 static Near push_near(const BoxNode& node, const PointInTree& p, float limit,
                                      float* squares, std::uint32_t* open) {
    const __m512 sum = squares_of(node, p);
    const __m512i child = _mm512_load_si512(node.child);
    const __mmask16 mask = near(child, sum, limit);
    if (mask == 0) return {};
    const __mmask16 least = _mm512_mask_cmp_ps_mask(mask, sum, least_of(mask, sum), _CMP_EQ_OQ);
    const int first = std::countr_zero(static_cast<unsigned>(least));
    const auto others = static_cast<__mmask16>(mask & ~(1u << first));
    _mm512_storeu_ps(squares, _mm512_maskz_compress_ps(others, sum));
    _mm512_storeu_si512(open, _mm512_maskz_compress_epi32(others, child));
    return {node.child[first],
            static_cast<std::size_t>(std::popcount(static_cast<unsigned>(others)))};
  }

  // The least number of a mask, in every lane.
  SKYWAY_AVX512 static __m512 least_of(__mmask16 mask, __m512 numbers) {
    __m512 n =
        _mm512_mask_mov_ps(_mm512_set1_ps(std::numeric_limits<float>::infinity()), mask, numbers);
    n = min(n, _mm512_maskz_shuffle_f32x4(0xffff, n, n, 0x4e));
    n = min(n, _mm512_maskz_shuffle_f32x4(0xffff, n, n, 0xb1));
    n = min(n, _mm512_maskz_shuffle_ps(0xffff, n, n, 0x4e));
    return min(n, _mm512_maskz_shuffle_ps(0xffff, n, n, 0xb1));
  }

  SKYWAY_AVX512 static std::size_t push(const BoxNode& node, unsigned mask, std::uint32_t* open) {
    const __m512i picked =
        _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), _mm512_load_si512(node.child));
    _mm512_storeu_si512(open, picked);
    return static_cast<std::size_t>(std::popcount(mask));
  }
};
#endif

// Of a lambda that is compiled anew for each kind of processor, with all that it calls.
#define SKYWAY_ANY_LANES __attribute__((always_inline))

#if defined(__x86_64__)
template <class F>
SKYWAY_AVX2 auto on_avx2(const F& f) {
  return f(Avx2{});
}
template <class F>
SKYWAY_AVX512 auto on_avx512(const F& f) {
  return f(Avx512{});
}
#endif

}  // namespace lanes

// What f(lanes) returns, for the best lanes that this processor has. f is SKYWAY_ANY_LANES.
template <class F>
auto with_lanes(const F& f) {
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return lanes::on_avx512(f);
  if (lanes::Avx2::usable()) return lanes::on_avx2(f);
#endif
  return f(lanes::Plain{});
}

}  // namespace geom
