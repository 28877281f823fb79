#pragma once

// Eight rays side by side with AVX-512, and the depths where they end: bit for bit those of one ray
// after the other.

#if defined(__x86_64__)
#include <immintrin.h>
#include <sys/platform/x86.h>

#include <limits>

#include "geom/picture/view.h"

namespace geom::picture {

#define SKYWAY_RAY_LANES [[gnu::target("avx512f,avx512vl")]]

struct RayLanes {
  static constexpr int kLanes = 8;
  static constexpr __mmask8 kAll = 0xff;

  __m512d origin[3];  // by axis
  __m512d direction[3];

  static bool usable() {
    static const bool has = CPU_FEATURE_ACTIVE(AVX512F) && CPU_FEATURE_ACTIVE(AVX512VL);
    return has;
  }

  // Through pixels of two rows of four: (x, y) to (x + 3, y + 1).
  SKYWAY_RAY_LANES RayLanes(const Rays& rays, int x, int y) {
    const __m512d u = _mm512_add_pd(_mm512_set_pd(3, 2, 1, 0, 3, 2, 1, 0), _mm512_set1_pd(x));
    const __m512d v = _mm512_add_pd(_mm512_set_pd(1, 1, 1, 1, 0, 0, 0, 0), _mm512_set1_pd(y));
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const __m512d right = _mm512_mul_pd(u, _mm512_set1_pd(rays.right()[i]));
      const __m512d down = _mm512_mul_pd(v, _mm512_set1_pd(rays.down()[i]));
      const __m512d corner = _mm512_set1_pd(rays.corner()[i]);
      const __m512d own = _mm512_add_pd(_mm512_add_pd(corner, right), down);
      const __m512d shared = _mm512_set1_pd(rays.shared()[i]);
      origin[i] = rays.parallel() ? own : shared;
      direction[i] = rays.parallel() ? shared : own;
    }
  }

  SKYWAY_RAY_LANES static void store(__m512d values, float* to) {
    _mm256_storeu_ps(to, _mm512_maskz_cvtpd_ps(kAll, values));
  }

  SKYWAY_RAY_LANES static __m256i load(const unsigned* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }

  // The numbers of each ray's own axis.
  SKYWAY_RAY_LANES static __m512d along(const __m512d* v, __m512i axis) {
    const __mmask8 is_y = _mm512_cmpeq_epi64_mask(axis, _mm512_set1_epi64(1));
    const __mmask8 is_z = _mm512_cmpeq_epi64_mask(axis, _mm512_set1_epi64(2));
    return _mm512_mask_mov_pd(_mm512_mask_mov_pd(v[0], is_y, v[1]), is_z, v[2]);
  }
};

// What Embree says of eight rays: the surface that each meets, and, of a tube, where.
struct MetByRays {
  const unsigned* geometry;   // 0: the boxes, kNone: nothing
  const unsigned* primitive;  // of the boxes: a number in the list of all their sides
  const float* depth;
  unsigned none;
};

// What can be met: the sides of all boxes, and the ground, which hides what is below it.
struct Surfaces {
  const double* sides;
  double ground;
  double near;  // metres in front of the eye
};

// Writes eight depths; 0 of the sky.
SKYWAY_RAY_LANES inline void write_depths(const RayLanes& rays, const MetByRays& met,
                                          const Surfaces& surfaces, float* out) {
  const __m256i geometry = RayLanes::load(met.geometry);
  const __mmask8 is_face = _mm256_cmpeq_epi32_mask(geometry, _mm256_setzero_si256());
  const __mmask8 is_none =
      _mm256_cmpeq_epi32_mask(geometry, _mm256_set1_epi32(static_cast<int>(met.none)));
  const auto is_tube = static_cast<__mmask8>(~(is_face | is_none));
  const __m512i side = _mm512_maskz_cvtepu32_epi64(is_face, RayLanes::load(met.primitive));
  // A third of it, by the inverse of 3.
  const __m512i third = _mm512_maskz_srli_epi64(
      RayLanes::kAll, _mm512_maskz_mul_epu32(RayLanes::kAll, side, _mm512_set1_epi64(0xaaaaaaab)),
      33);
  const __m512i axis =
      _mm512_sub_epi64(side, _mm512_add_epi64(third, _mm512_add_epi64(third, third)));
  const __m512d plane =
      _mm512_mask_i64gather_pd(_mm512_setzero_pd(), is_face, side, surfaces.sides, 8);
  const __m512d none = _mm512_set1_pd(std::numeric_limits<double>::infinity());
  __m512d first =
      _mm512_mask_div_pd(none, is_face, _mm512_sub_pd(plane, RayLanes::along(rays.origin, axis)),
                         RayLanes::along(rays.direction, axis));
  first = _mm512_mask_cvtps_pd(first, is_tube, _mm256_loadu_ps(met.depth));
  const __m512d down = rays.direction[2];
  const __m512d fall = _mm512_sub_pd(_mm512_set1_pd(surfaces.ground), rays.origin[2]);
  __mmask8 is_ground = _mm512_cmp_pd_mask(down, _mm512_setzero_pd(), _CMP_LT_OQ);
  is_ground = _mm512_mask_cmp_pd_mask(
      is_ground, fall, _mm512_mul_pd(_mm512_set1_pd(surfaces.near), down), _CMP_LT_OQ);
  is_ground = _mm512_mask_cmp_pd_mask(is_ground, _mm512_mul_pd(first, down), fall, _CMP_LT_OQ);
  first = _mm512_mask_div_pd(first, is_ground, fall, down);
  const auto seen = static_cast<__mmask8>(is_ground | ~is_none);
  RayLanes::store(_mm512_maskz_mov_pd(seen, first), out);
}

}  // namespace geom::picture
#endif
