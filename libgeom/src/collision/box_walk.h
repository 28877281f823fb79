#pragma once

// Walks through a BoxTree: the boxes that may meet a segment or a region, and those that may be
// near a point.

#include <array>
#include <bit>
#include <cstdint>

#include "box_lanes.h"
#include "box_tree.h"

namespace geom {
namespace walk {

inline constexpr std::size_t kStack = (BoxNode::kLanes - 1) * BoxTree::kMostDepth + 1;

// Asks f about every box whose nodes `children` lets through, until one answers true. Children go
// onto the stack without a loop, and its first is none: what would be three branches a node that no
// processor foresees is one.
template <class Lanes, class Question, class F>
[[gnu::always_inline]] inline bool any(const BoxNode* nodes,
                                       unsigned (*children)(const BoxNode&, const Question&),
                                       const Question& question, const F& f) {
  std::array<std::uint32_t, kStack + BoxNode::kLanes> open;
  open[0] = BoxNode::kNone;
  std::size_t count = 1;
  std::uint32_t next = 0;
  for (;;) {
    const BoxNode& node = nodes[next];
    count += Lanes::push(node, children(node, question), &open[count]);
    while (((next = open[--count]) & BoxNode::kBox) != 0) {
      if (next == BoxNode::kNone) return false;
      if (f(next & ~BoxNode::kBox)) return true;
    }
  }
}

struct Open {
  float square;
  std::uint32_t child;
};

// Asks f about the boxes that may be within a radius, of each node the nearer first; f returns the
// radius from there on.
template <class Lanes, class F>
[[gnu::always_inline]] inline void nearest(const BoxNode* nodes, const PointInTree& p,
                                           double radius, const F& f) {
  std::array<Open, kStack> open;
  std::size_t count = 0;
  Open next{0, 0};
  float limit = p.limit(radius);
  for (;;) {
    const BoxNode& node = nodes[next.child];
    alignas(64) std::array<float, BoxNode::kLanes> square;
    const std::size_t before = count;
    for (unsigned left = Lanes::near(node, p, limit, square.data()); left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      // The furthest lies deepest.
      std::size_t at = count++;
      for (; at > before && open[at - 1].square < square[k]; --at) open[at] = open[at - 1];
      open[at] = {square[k], node.child[k]};
    }
    for (;;) {
      if (count == 0) return;
      next = open[--count];
      if (next.square > limit) continue;
      if ((next.child & BoxNode::kBox) == 0) break;
      const double closer = f(next.child & ~BoxNode::kBox);
      if (closer < radius) limit = p.limit(radius = closer);
    }
  }
}

// Down to the nearest child each time.
template <class Lanes>
[[gnu::always_inline]] inline std::uint32_t dive(const BoxNode* nodes, const PointInTree& p) {
  std::uint32_t next = 0;
  while ((next & BoxNode::kBox) == 0) next = nodes[next].child[Lanes::nearest(nodes[next], p)];
  return next & ~BoxNode::kBox;
}

#if defined(__x86_64__)
SKYWAY_AVX2 inline std::uint32_t dive_avx2(const BoxNode* nodes, const PointInTree& p) {
  return dive<lanes::Avx2>(nodes, p);
}
SKYWAY_AVX512 inline std::uint32_t dive_avx512(const BoxNode* nodes, const PointInTree& p) {
  return dive<lanes::Avx512>(nodes, p);
}
template <class F>
SKYWAY_AVX2 bool any_on_avx2(const BoxNode* nodes, const SegmentInTree& s, const F& f) {
  return any<lanes::Avx2>(nodes, lanes::Avx2::on, s, f);
}
template <class F>
SKYWAY_AVX2 bool any_in_avx2(const BoxNode* nodes, const RegionInTree& r, const F& f) {
  return any<lanes::Avx2>(nodes, lanes::Avx2::in, r, f);
}
template <class F>
SKYWAY_AVX2 void near_avx2(const BoxNode* nodes, const PointInTree& p, double radius, const F& f) {
  nearest<lanes::Avx2>(nodes, p, radius, f);
}
template <class F>
SKYWAY_AVX512 bool any_on_avx512(const BoxNode* nodes, const SegmentInTree& s, const F& f) {
  return any<lanes::Avx512>(nodes, lanes::Avx512::on, s, f);
}
template <class F>
SKYWAY_AVX512 bool any_in_avx512(const BoxNode* nodes, const RegionInTree& r, const F& f) {
  return any<lanes::Avx512>(nodes, lanes::Avx512::in, r, f);
}
template <class F>
SKYWAY_AVX512 void near_avx512(const BoxNode* nodes, const PointInTree& p, double radius,
                               const F& f) {
  nearest<lanes::Avx512>(nodes, p, radius, f);
}
#endif

}  // namespace walk

// Calls f(box) for boxes that the closed segment may meet, until it returns true; returns whether
// it did. All that the segment meets are among them.
template <class F>
bool any_on_segment(const BoxTree& tree, const Vec3& a, const Vec3& b, const F& f) {
  const SegmentInTree s(tree.frame, a, b);
  if (s.outside) return false;
  const BoxNode* const nodes = tree.nodes.data();
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::any_on_avx512(nodes, s, f);
  if (lanes::Avx2::usable()) return walk::any_on_avx2(nodes, s, f);
#endif
  return walk::any<lanes::Plain>(nodes, lanes::Plain::on, s, f);
}

// The same of the boxes that the closed region may meet.
template <class F>
bool any_in_region(const BoxTree& tree, const Aabb& region, const F& f) {
  const RegionInTree r(tree.frame, region);
  const BoxNode* const nodes = tree.nodes.data();
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::any_in_avx512(nodes, r, f);
  if (lanes::Avx2::usable()) return walk::any_in_avx2(nodes, r, f);
#endif
  return walk::any<lanes::Plain>(nodes, lanes::Plain::in, r, f);
}

// Calls f(box) for boxes that may be within `radius` of the point, about the nearest first. f
// returns how near later ones must be. All that are as near are among them.
template <class F>
void each_near(const BoxTree& tree, const Vec3& p, double radius, const F& f) {
  const PointInTree at(tree.frame, p);
  const BoxNode* const nodes = tree.nodes.data();
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::near_avx512(nodes, at, radius, f);
  if (lanes::Avx2::usable()) return walk::near_avx2(nodes, at, radius, f);
#endif
  walk::nearest<lanes::Plain>(nodes, at, radius, f);
}

// A box that is likely near the point.
inline std::uint32_t likely_near(const BoxTree& tree, const Vec3& p) {
  const PointInTree at(tree.frame, p);
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::dive_avx512(tree.nodes.data(), at);
  if (lanes::Avx2::usable()) return walk::dive_avx2(tree.nodes.data(), at);
#endif
  return walk::dive<lanes::Plain>(tree.nodes.data(), at);
}

}  // namespace geom
