#pragma once

// Looks at several bends, or nodes of their tree, at once: four with AVX2, where the processor has
// it, with the same bits as one by one.

#if defined(__x86_64__)
#include <immintrin.h>
#include <sys/platform/x86.h>
#endif

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "bends.h"
#include "onward.h"

namespace plan {

// Where a search looks from a bend.
struct Look {
  Vec3 from;
  const Onward& onward;
  double square;  // m2, that bends are away at most
  double left;    // m, that a path on over a bend to the goal is shorter than
};

// Bends as columns of numbers.
class BendLanes {
 public:
  static constexpr double kSpare = 1e-6;  // m, far more than what is rounded

  explicit BendLanes(std::span<const Bend> bends) {
    const std::size_t room = bends.size() + kLanes;  // the last look may go beyond the end
    for (auto& column : place_) column.resize(room);
    for (auto& column : back_) column.resize(room);
    for (std::size_t i = 0; i < bends.size(); ++i) {
      const Bend& bend = bends[i];
      for (std::size_t k = 0; k < 3; ++k) place_[k][i] = bend.position[static_cast<int>(k)];
      const auto axis = static_cast<std::size_t>(bend.axis);
      back_[(axis + 1) % 3][i] = -bend.outward[0];
      back_[3 + (axis + 2) % 3][i] = -bend.outward[1];
    }
  }

  // Bit k of the answer says whether bend first + k is one that `look` goes on to: it is near
  // enough, a path over it to the goal is at most kSpare too long, `onward` goes there, and the
  // line is tangent to its box. Writes the squared distances. Of at most BendTree::kBendsOfLeaf
  // bends. to_goal[i]: how far bend i is from the goal, in metres; room for three numbers past the
  // last.
  unsigned reached(std::size_t first, std::size_t count, const Look& look, const double* to_goal,
                   double* squares) const {
#if defined(__x86_64__)
    static const bool lanes = CPU_FEATURE_ACTIVE(AVX2);
    if (lanes) return in_lanes(first, count, look, to_goal + first, squares);
#endif
    return one_by_one(first, count, look, to_goal, squares);
  }

  // Bit k of the answer says whether child k of node i may have bends that `look` looks for.
  // to_goal[n]: how far node n is from the goal, in metres; room for three numbers past the last.
  static unsigned reached(const BendTree& tree, std::uint32_t i, const Look& look,
                          const double* to_goal) {
#if defined(__x86_64__)
    static const bool lanes = CPU_FEATURE_ACTIVE(AVX2);
    if (lanes) return in_lanes(tree.children(i), look, to_goal + tree.node(i).first);
#endif
    return one_by_one(tree, i, look, to_goal);
  }

  // The same, on any processor.
  static unsigned one_by_one(const BendTree& tree, std::uint32_t i, const Look& look,
                             const double* to_goal) {
    unsigned out = 0;
    const BendTree::Node& node = tree.node(i);
    for (std::uint32_t k = 0; k < node.count; ++k) {
      const BendTree::Node& child = tree.node(node.first + k);
      const double square = BendTree::squared_distance(child, look.from);
      const double left = look.left - to_goal[node.first + k];
      const bool yes =
          square <= look.square && left > 0 && square < left * left && !look.onward.misses(child);
      out |= static_cast<unsigned>(yes) << k;
    }
    return out;
  }
  unsigned one_by_one(std::size_t first, std::size_t count, const Look& look, const double* to_goal,
                      double* squares) const {
    unsigned out = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k;
      const Vec3 d = Vec3(place_[0][i], place_[1][i], place_[2][i]) - look.from;
      squares[k] = d.squaredNorm();
      const double left = look.left + kSpare - to_goal[i];
      const Across back{d[0] * back_[0][i] + d[1] * back_[1][i] + d[2] * back_[2][i],
                        d[0] * back_[3][i] + d[1] * back_[4][i] + d[2] * back_[5][i]};
      const bool near = (squares[k] <= look.square) & (left > 0) & (squares[k] < left * left);
      const bool yes = near & look.onward.goes(d) & back.tangent();
      out |= static_cast<unsigned>(yes) << k;
    }
    return out;
  }

 private:
  static constexpr std::size_t kLanes = 4;

#if defined(__x86_64__)
#define SKYWAY_BEND_LANES [[gnu::target("avx2")]]
  SKYWAY_BEND_LANES static __m256d size_of(__m256d x) {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x);
  }

  // Across::tangent().
  SKYWAY_BEND_LANES static __m256d tangent(__m256d x, __m256d y) {
    const __m256d least = _mm256_min_pd(size_of(x), size_of(y));
    return _mm256_or_pd(_mm256_cmp_pd(_mm256_mul_pd(x, y), _mm256_setzero_pd(), _CMP_LE_OQ),
                        _mm256_cmp_pd(least, _mm256_set1_pd(Across::kFlush), _CMP_LT_OQ));
  }

  // Onward::goes().
  SKYWAY_BEND_LANES static __m256d goes(const __m256d* d, const Onward::Terms& on) {
    const __m256d x = _mm256_mul_pd(d[on.first_axis], _mm256_set1_pd(on.outward[0]));
    const __m256d y = _mm256_mul_pd(d[on.second_axis], _mm256_set1_pd(on.outward[1]));
    const __m256d share =
        _mm256_mul_pd(_mm256_set1_pd(on.ratio), _mm256_add_pd(size_of(x), size_of(y)));
    const __m256d side = on.second_side
                             ? _mm256_and_pd(_mm256_cmp_pd(x, y, _CMP_GT_OQ),
                                             _mm256_cmp_pd(size_of(y), share, _CMP_GE_OQ))
                             : _mm256_and_pd(_mm256_cmp_pd(x, y, _CMP_LE_OQ),
                                             _mm256_cmp_pd(size_of(y), share, _CMP_LE_OQ));
    return _mm256_and_pd(side, tangent(x, y));
  }

  // The sum of three columns, each times its coordinate of a direction along an axis.
  SKYWAY_BEND_LANES static __m256d along(const std::vector<double>* columns, std::size_t i,
                                         const __m256d* d) {
    __m256d out = _mm256_mul_pd(_mm256_loadu_pd(columns[0].data() + i), d[0]);
    out = _mm256_add_pd(out, _mm256_mul_pd(_mm256_loadu_pd(columns[1].data() + i), d[1]));
    return _mm256_add_pd(out, _mm256_mul_pd(_mm256_loadu_pd(columns[2].data() + i), d[2]));
  }

  // Whether squared distances are at most `square`, and below those of what is left.
  SKYWAY_BEND_LANES static __m256d within(__m256d apart, double square, __m256d left) {
    return _mm256_and_pd(
        _mm256_cmp_pd(apart, _mm256_set1_pd(square), _CMP_LE_OQ),
        _mm256_and_pd(_mm256_cmp_pd(left, _mm256_setzero_pd(), _CMP_GT_OQ),
                      _mm256_cmp_pd(apart, _mm256_mul_pd(left, left), _CMP_LT_OQ)));
  }

  SKYWAY_BEND_LANES static unsigned in_lanes(const BendTree::Children& children, const Look& look,
                                             const double* to_goal) {
    static_assert(BendTree::kChildren == kLanes);
    __m256d low[3];   // from the bend to the child's lower faces,
    __m256d back[3];  // and from its upper faces to the bend
    __m256d off[3];
#pragma GCC unroll 3
    for (std::size_t a = 0; a < 3; ++a) {
      const __m256d p = _mm256_set1_pd(look.from[static_cast<int>(a)]);
      low[a] = _mm256_sub_pd(_mm256_cvtps_pd(_mm_loadu_ps(children.min[a])), p);
      back[a] = _mm256_sub_pd(p, _mm256_cvtps_pd(_mm_loadu_ps(children.max[a])));
      off[a] = _mm256_max_pd(_mm256_max_pd(low[a], back[a]), _mm256_setzero_pd());
    }
    // In the order of squaredNorm().
    const __m256d apart =
        _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(off[0], off[0]), _mm256_mul_pd(off[1], off[1])),
                      _mm256_mul_pd(off[2], off[2]));
    const __m256d left = _mm256_sub_pd(_mm256_set1_pd(look.left), _mm256_loadu_pd(to_goal));
    const __m256d near = within(apart, look.square, left);
    if (_mm256_testz_pd(near, near)) return 0;
    const Onward::Terms on = look.onward.terms();
    const __m256d missed = misses(on, low, back);
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_andnot_pd(missed, near)));
  }

  // Onward::misses().
  SKYWAY_BEND_LANES static __m256d misses(const Onward::Terms& on, const __m256d* low,
                                          const __m256d* back) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    const __m256d forgiven = _mm256_set1_pd(Onward::kForgiven);
    const __m256d minus_forgiven = _mm256_set1_pd(-Onward::kForgiven);
    // Outward from the bend along both axes: the least, and minus the most.
    const bool x_up = on.outward[0] > 0;
    const bool y_up = on.outward[1] > 0;
    const __m256d x0 = (x_up ? low : back)[on.first_axis];
    const __m256d y0 = (y_up ? low : back)[on.second_axis];
    const __m256d x1 = _mm256_xor_pd(sign, (x_up ? back : low)[on.first_axis]);
    const __m256d y1 = _mm256_xor_pd(sign, (y_up ? back : low)[on.second_axis]);
    const __m256d aside = on.second_side
                              ? _mm256_or_pd(_mm256_cmp_pd(x1, minus_forgiven, _CMP_LT_OQ),
                                             _mm256_cmp_pd(y0, forgiven, _CMP_GT_OQ))
                              : _mm256_or_pd(_mm256_cmp_pd(x0, forgiven, _CMP_GT_OQ),
                                             _mm256_cmp_pd(y1, minus_forgiven, _CMP_LT_OQ));
    const __m256d behind = _mm256_add_pd(_mm256_mul_pd(_mm256_set1_pd(on.ratio), x0),
                                         _mm256_mul_pd(_mm256_set1_pd(1 - on.ratio), y0));
    return _mm256_or_pd(aside, _mm256_cmp_pd(behind, forgiven, _CMP_GT_OQ));
  }

  SKYWAY_BEND_LANES unsigned in_lanes(std::size_t first, std::size_t count, const Look& look,
                                      const double* to_goal, double* squares) const {
    const Onward::Terms on = look.onward.terms();
    const __m256d most = _mm256_set1_pd(look.left + kSpare);
    unsigned out = 0;
    for (std::size_t k = 0; k < count; k += kLanes) {
      __m256d d[3];
#pragma GCC unroll 3
      for (std::size_t a = 0; a < 3; ++a) {
        d[a] = _mm256_sub_pd(_mm256_loadu_pd(place_[a].data() + first + k),
                             _mm256_set1_pd(look.from[static_cast<int>(a)]));
      }
      // In the order of squaredNorm().
      const __m256d apart =
          _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(d[0], d[0]), _mm256_mul_pd(d[1], d[1])),
                        _mm256_mul_pd(d[2], d[2]));
      _mm256_storeu_pd(squares + k, apart);
      const __m256d left = _mm256_sub_pd(most, _mm256_loadu_pd(to_goal + k));
      const __m256d near = within(apart, look.square, left);
      if (_mm256_testz_pd(near, near)) continue;  // most end here or below, before what costs most
      const __m256d there = _mm256_and_pd(near, goes(d, on));
      if (_mm256_testz_pd(there, there)) continue;
      const __m256d back = tangent(along(&back_[0], first + k, d), along(&back_[3], first + k, d));
      out |= static_cast<unsigned>(_mm256_movemask_pd(_mm256_and_pd(there, back))) << k;
    }
    return out & ((1u << count) - 1);
  }
#undef SKYWAY_BEND_LANES
#endif

  std::array<std::vector<double>, 3> place_;
  std::array<std::vector<double>, 6> back_;  // signs by axis, for the first side and the second
};

}  // namespace plan
