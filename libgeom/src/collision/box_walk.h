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

// Asks f about every box whose nodes `children` lets through, until one answers true. Of each node
// one child comes next at once and the others go onto the stack, without a loop. The first there is
// none: what would be three branches a node that no processor foresees is one.
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
    const unsigned mask = children(node, question);
    const int last = std::bit_width(mask | 1) - 1;
    next = mask != 0 ? node.child[last] : open[count - 1];
    count += Lanes::push(node, mask & ~(1u << last), &open[count]);
    count -= mask == 0;
    while ((next & BoxNode::kBox) != 0) {
      if (next == BoxNode::kNone) return false;
      if (f(next & ~BoxNode::kBox)) return true;
      next = open[--count];
    }
  }
}

// Asks f about the boxes that may be within a radius; f returns the radius from there on. Of each
// node the nearest child comes first, the others as they lie: once something near was found, most
// are passed over.
template <class Lanes, class F>
[[gnu::always_inline]] inline void nearest(const BoxNode* nodes, const PointInTree& p,
                                           double radius, const F& f) {
  std::array<float, kStack + BoxNode::kLanes> square;
  std::array<std::uint32_t, kStack + BoxNode::kLanes> child;
  std::size_t count = 0;
  float limit = p.limit(radius);
  const auto ask = [&](std::uint32_t box) {
    const double closer = f(box & ~BoxNode::kBox);
    if (closer < radius) limit = p.limit(radius = closer);
  };
  const auto pop = [&] {
    while (count > 0) {
      if (square[--count] > limit) continue;
      if ((child[count] & BoxNode::kBox) == 0) return child[count];
      ask(child[count]);
    }
    return BoxNode::kNone;
  };
  for (std::uint32_t next = 0; next != BoxNode::kNone;) {
    const auto near = Lanes::push_near(nodes[next], p, limit, &square[count], &child[count]);
    count += near.others;
    next = near.nearest;
    if ((next & BoxNode::kBox) == 0) continue;
    if (next != BoxNode::kNone) ask(next);
    next = pop();
  }
}

#if defined(__x86_64__)
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

// Calls f(box) for boxes of a tree that the closed segment may meet, until it returns true; returns
// whether it did. All that the segment meets are among them.
template <class F>
bool any_on_segment(const BoxNode* nodes, const SegmentInTree& s, const F& f) {
  if (s.outside) return false;
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::any_on_avx512(nodes, s, f);
  if (lanes::Avx2::usable()) return walk::any_on_avx2(nodes, s, f);
#endif
  return walk::any<lanes::Plain>(nodes, lanes::Plain::on, s, f);
}

// The same of the boxes that the closed region may meet.
template <class F>
bool any_in_region(const BoxNode* nodes, const RegionInTree& r, const F& f) {
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::any_in_avx512(nodes, r, f);
  if (lanes::Avx2::usable()) return walk::any_in_avx2(nodes, r, f);
#endif
  return walk::any<lanes::Plain>(nodes, lanes::Plain::in, r, f);
}

// Calls f(box) for boxes that may be within `radius` of the point, about the nearest first. f
// returns how near later ones must be. All that are as near are among them.
template <class F>
void each_near(const BoxNode* nodes, const PointInTree& p, double radius, const F& f) {
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) return walk::near_avx512(nodes, p, radius, f);
  if (lanes::Avx2::usable()) return walk::near_avx2(nodes, p, radius, f);
#endif
  walk::nearest<lanes::Plain>(nodes, p, radius, f);
}

// The same of questions in metres.
template <class F>
bool any_on_segment(const BoxTree& tree, const Vec3& a, const Vec3& b, const F& f) {
  return any_on_segment(tree.nodes.data(), SegmentInTree(tree.frame, a, b), f);
}
template <class F>
bool any_in_region(const BoxTree& tree, const Aabb& region, const F& f) {
  return any_in_region(tree.nodes.data(), RegionInTree(tree.frame, region), f);
}
template <class F>
void each_near(const BoxTree& tree, const Vec3& p, double radius, const F& f) {
  each_near(tree.nodes.data(), PointInTree(tree.frame, p), radius, f);
}

}  // namespace geom
