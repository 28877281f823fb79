#pragma once

// Four boxes that segments are asked against at once: with AVX2, where the processor has it, and
// with the same answers one by one.

#if defined(__x86_64__)
#include <immintrin.h>
#include <sys/platform/x86.h>
#endif

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geom/shape/aabb.h"

namespace plan {

using geom::Vec3;

class BlockerLanes {
 public:
  static constexpr std::size_t kLanes = 4;
  static constexpr double kSpare = 1e-6;  // m, far more than what is rounded

  // Places without a box are infinitely far from everything.
  BlockerLanes() {
    for (auto& column : min_) std::fill_n(column, kLanes, std::numeric_limits<double>::infinity());
    for (auto& column : max_) std::fill_n(column, kLanes, -std::numeric_limits<double>::infinity());
  }

  void put(std::size_t i, const geom::Aabb& box) {
    for (int k = 0; k < 3; ++k) min_[k][i] = box.min[k], max_[k][i] = box.max[k];
  }

  // Bit i of the answer is geom::segment_hits(a, b, box i). `a` and `b` are finite.
  unsigned hit_by(const Vec3& a, const Vec3& b) const {
#if defined(__x86_64__)
    if (has_lanes()) return hit_in_lanes(a, b);
#endif
    return hit_one_by_one(a, b);
  }

  // Bit i of the answer is set only if box i blocks all segments from `a` to points of the closed
  // box: seen from `a`, the box lies behind a side of box i and within its outline, with kSpare.
  unsigned hiding(const Vec3& a, const geom::Aabb& box) const {
#if defined(__x86_64__)
    if (has_lanes()) return hiding_in_lanes(a, box);
#endif
    return hiding_one_by_one(a, box);
  }

  // The same, on any processor.
  unsigned hit_one_by_one(const Vec3& a, const Vec3& b) const {
    unsigned out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
      out |= static_cast<unsigned>(geom::segment_hits(a, b, box_at(i))) << i;
    }
    return out;
  }
  unsigned hiding_one_by_one(const Vec3& a, const geom::Aabb& box) const {
    unsigned out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
      for (int k = 0; k < 3; ++k) out |= static_cast<unsigned>(behind(a, box, k, i)) << i;
    }
    return out;
  }

 private:
  geom::Aabb box_at(std::size_t i) const {
    return {{min_[0][i], min_[1][i], min_[2][i]}, {max_[0][i], max_[1][i], max_[2][i]}};
  }

  // Whether the box lies behind the side of box i across axis k, and within its outline.
  bool behind(const Vec3& a, const geom::Aabb& box, int k, std::size_t i) const {
    const bool above = min_[k][i] > a[k];
    if (!above && !(max_[k][i] < a[k])) return false;
    const double side = above ? min_[k][i] - a[k] : a[k] - max_[k][i];
    const double near = above ? box.min[k] - a[k] : a[k] - box.max[k];
    const double far = above ? box.max[k] - a[k] : a[k] - box.min[k];
    if (!(near > side)) return false;
    bool within = true;
    for (const int j : {(k + 1) % 3, (k + 2) % 3}) {
      const double low = box.min[j] - a[j];
      const double high = box.max[j] - a[j];
      within &= low * side >= (min_[j][i] - a[j] + kSpare) * (low < 0 ? near : far);
      within &= high * side <= (max_[j][i] - a[j] - kSpare) * (high > 0 ? near : far);
    }
    return within;
  }

#if defined(__x86_64__)
#define SKYWAY_BLOCKER_LANES [[gnu::target("avx2")]]
  static bool has_lanes() {
    static const bool lanes = CPU_FEATURE_ACTIVE(AVX2);
    return lanes;
  }

  SKYWAY_BLOCKER_LANES static __m256d all(double x) { return _mm256_set1_pd(x); }
  SKYWAY_BLOCKER_LANES static __m256d either(__m256d a, __m256d b) { return _mm256_or_pd(a, b); }
  SKYWAY_BLOCKER_LANES static __m256d both(__m256d a, __m256d b) { return _mm256_and_pd(a, b); }
  SKYWAY_BLOCKER_LANES __m256d min(int k) const { return _mm256_loadu_pd(min_[k]); }
  SKYWAY_BLOCKER_LANES __m256d max(int k) const { return _mm256_loadu_pd(max_[k]); }

  // On which side of the line through a and b corners are, where rounding leaves no doubt.
  struct Sides {
    __m256d left;
    __m256d right;
  };
  SKYWAY_BLOCKER_LANES static Sides sides(double ax, double ay, double dx, double dy, __m256d x,
                                          __m256d y) {
    const __m256d one = _mm256_mul_pd(all(dx), _mm256_sub_pd(y, all(ay)));
    const __m256d other = _mm256_mul_pd(all(dy), _mm256_sub_pd(x, all(ax)));
    const __m256d det = _mm256_sub_pd(one, other);
    const __m256d sign = all(-0.0);
    const __m256d sum = _mm256_add_pd(_mm256_andnot_pd(sign, one), _mm256_andnot_pd(sign, other));
    // The filter of geom::orientation().
    const __m256d bound =
        _mm256_add_pd(_mm256_mul_pd(all(3.3306690738754716e-16), sum), all(1e-290));
    return {_mm256_cmp_pd(det, bound, _CMP_GT_OQ),
            _mm256_cmp_pd(det, _mm256_xor_pd(sign, bound), _CMP_LT_OQ)};
  }

  // The separating axes of geom::segment_hits(), which decides where they leave a doubt.
  SKYWAY_BLOCKER_LANES unsigned hit_in_lanes(const Vec3& a, const Vec3& b) const {
    __m256d missed = _mm256_setzero_pd();
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      missed = either(missed, _mm256_cmp_pd(all(std::max(a[k], b[k])), min(k), _CMP_LT_OQ));
      missed = either(missed, _mm256_cmp_pd(all(std::min(a[k], b[k])), max(k), _CMP_GT_OQ));
    }
    __m256d sure = all(std::bit_cast<double>(~std::uint64_t{0}));
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (a[i] == b[i] || a[j] == b[j]) continue;
      const bool rising = (b[i] >= a[i]) == (b[j] >= a[j]);
      const double dx = b[i] - a[i];
      const double dy = b[j] - a[j];
      const Sides one = sides(a[i], a[j], dx, dy, min(i), rising ? max(j) : min(j));
      const Sides other = sides(a[i], a[j], dx, dy, max(i), rising ? min(j) : max(j));
      missed = either(missed, either(both(one.left, other.left), both(one.right, other.right)));
      sure = both(sure, both(either(one.left, one.right), either(other.left, other.right)));
    }
    unsigned hit = 0xf & ~static_cast<unsigned>(_mm256_movemask_pd(missed));
    unsigned doubted = hit & ~static_cast<unsigned>(_mm256_movemask_pd(sure));
    for (; doubted != 0; doubted &= doubted - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(doubted));
      if (!geom::segment_hits(a, b, box_at(i))) hit &= ~(1u << i);
    }
    return hit;
  }

  // behind(), of all boxes and axes.
  SKYWAY_BLOCKER_LANES unsigned hiding_in_lanes(const Vec3& a, const geom::Aabb& box) const {
    __m256d hidden = _mm256_setzero_pd();
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      const __m256d up = _mm256_sub_pd(min(k), all(a[k]));
      const __m256d down = _mm256_sub_pd(all(a[k]), max(k));
      const __m256d above = _mm256_cmp_pd(min(k), all(a[k]), _CMP_GT_OQ);
      const __m256d beside = either(above, _mm256_cmp_pd(max(k), all(a[k]), _CMP_LT_OQ));
      const __m256d side = _mm256_blendv_pd(down, up, above);
      const double low_k = box.min[k] - a[k];
      const double high_k = box.max[k] - a[k];
      const __m256d near = _mm256_blendv_pd(all(a[k] - box.max[k]), all(low_k), above);
      const __m256d behind = both(beside, _mm256_cmp_pd(near, side, _CMP_GT_OQ));
      if (_mm256_testz_pd(behind, behind)) continue;
      const __m256d far = _mm256_blendv_pd(all(a[k] - box.min[k]), all(high_k), above);
      __m256d within = behind;
      for (const int j : {(k + 1) % 3, (k + 2) % 3}) {
        const double low = box.min[j] - a[j];
        const double high = box.max[j] - a[j];
        const __m256d least = _mm256_add_pd(_mm256_sub_pd(min(j), all(a[j])), all(kSpare));
        const __m256d most = _mm256_sub_pd(_mm256_sub_pd(max(j), all(a[j])), all(kSpare));
        within =
            both(within, _mm256_cmp_pd(_mm256_mul_pd(all(low), side),
                                       _mm256_mul_pd(least, low < 0 ? near : far), _CMP_GE_OQ));
        within =
            both(within, _mm256_cmp_pd(_mm256_mul_pd(all(high), side),
                                       _mm256_mul_pd(most, high > 0 ? near : far), _CMP_LE_OQ));
      }
      hidden = either(hidden, within);
    }
    return static_cast<unsigned>(_mm256_movemask_pd(hidden));
  }
#undef SKYWAY_BLOCKER_LANES
#endif

  double min_[3][kLanes];
  double max_[3][kLanes];
};

}  // namespace plan
