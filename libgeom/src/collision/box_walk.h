#pragma once

// Walks through a BoxTree: the boxes that may meet a segment or a region, and those that may be
// near a point.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>

#include "box_lanes.h"
#include "box_tree.h"

namespace geom {
namespace walk {

// Of walks whose boxes all are asked about.
struct NeverSure {};

inline constexpr std::size_t kStack = (BoxNode::kLanes - 1) * BoxTree::kMostDepth + 1;

// Asks f about every box whose nodes `children` lets through, until one answers true; sure(box) of
// one that surely is met ends the walk at once. Of each node one child comes next and the others go
// onto the stack, without a loop. The first there is none: what would be three branches a node that
// no processor foresees is one.
template <class Lanes, class Question, class F, class Sure>
SKYWAY_ANY_LANES inline bool any(const BoxNode* nodes,
                                 lanes::Met (*children)(const BoxNode&, const Question&),
                                 const Question& question, const F& f, const Sure& sure) {
  std::array<std::uint32_t, kStack + BoxNode::kLanes> open;
  open[0] = BoxNode::kNone;
  std::size_t count = 1;
  std::uint32_t next = 0;
  for (;;) {
    const BoxNode& node = nodes[next];
    const lanes::Met met = children(node, question);
    if constexpr (!std::is_same_v<Sure, NeverSure>) {
      if (const unsigned boxes = met.surely & Lanes::boxes(node); boxes != 0) {
        sure(node.child[std::countr_zero(boxes)] & ~BoxNode::kBox);
        return true;
      }
    }
    const unsigned mask = met.may;
    const int last = std::bit_width(mask | 1) - 1;
    const std::uint32_t first = node.child[last];
    const std::uint32_t waiting = open[count - 1];
    next = mask != 0 ? first : waiting;
    count += Lanes::push(node, mask & ~(1u << last), &open[count]);
    count -= mask == 0;
    while ((next & BoxNode::kBox) != 0) {
      if (next == BoxNode::kNone) return false;
      if (f(next & ~BoxNode::kBox)) return true;
      next = open[--count];
    }
  }
}

// Boxes of a region that are given on together.
inline constexpr std::size_t kBatch = 64;

// Gives f all boxes that the region may meet, some at a time, until it answers true. Which comes
// first does not matter here, so boxes do not wait on the stack, and the only branch is the end.
template <class Lanes, class F>
SKYWAY_ANY_LANES inline bool in_batches(const BoxNode* nodes, const RegionInTree& r, const F& f) {
  std::array<std::uint32_t, kStack + BoxNode::kLanes> open;
  std::array<std::uint32_t, kBatch + BoxNode::kLanes> batch;
  open[0] = 0;
  std::size_t count = 1;
  std::size_t boxes = 0;
  do {
    const BoxNode& node = nodes[open[--count]];
    const unsigned mask = Lanes::in(node, r).may;
    const unsigned leaves = Lanes::boxes(node);
    count += Lanes::push(node, mask & ~leaves, &open[count]);
    boxes += Lanes::push(node, mask & leaves, &batch[boxes]);
    if (boxes > kBatch - BoxNode::kLanes) {
      if (f(std::span<const std::uint32_t>(batch.data(), boxes))) return true;
      boxes = 0;
    }
  } while (count > 0);
  return boxes > 0 && f(std::span<const std::uint32_t>(batch.data(), boxes));
}

// Asks f about the boxes that may be within a radius; f returns the radius from there on. Of each
// node the nearest child comes first, the others as they lie: once something near was found, most
// are passed over.
template <class Lanes, class F>
SKYWAY_ANY_LANES inline void nearest(const BoxNode* nodes, const PointInTree& p, double radius,
                                     const F& f) {
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

}  // namespace walk

// Calls f(box) for boxes of a tree that the closed segment may meet, until it returns true; returns
// whether it did. All that the segment meets are among them. Where `sure` is given, a box that is
// met whatever roundings did ends the search: then sure(box) is called, and f is not. Each of these
// functions is compiled into its caller, who chose the lanes once for all trees that a question
// visits.
template <class Lanes, class F, class Sure = walk::NeverSure>
SKYWAY_ANY_LANES inline bool any_meeting(const BoxNode* nodes, const SegmentInTree& s, const F& f,
                                         const Sure& sure = {}) {
  return !s.outside && walk::any<Lanes>(nodes, Lanes::on, s, f, sure);
}

// The same of the boxes that the closed region may meet.
template <class Lanes, class F, class Sure = walk::NeverSure>
SKYWAY_ANY_LANES inline bool any_meeting(const BoxNode* nodes, const RegionInTree& r, const F& f,
                                         const Sure& sure = {}) {
  return walk::any<Lanes>(nodes, Lanes::in, r, f, sure);
}

// The same, but f gets some boxes at a time: those of a batch, as kBox | number.
template <class Lanes, class F>
SKYWAY_ANY_LANES inline bool each_in_region(const BoxNode* nodes, const RegionInTree& r,
                                            const F& f) {
  return walk::in_batches<Lanes>(nodes, r, f);
}

// Calls f(box) for boxes that may be within `radius` of the point, about the nearest first. f
// returns how near later ones must be. All that are as near are among them.
template <class Lanes, class F>
SKYWAY_ANY_LANES inline void each_near(const BoxNode* nodes, const PointInTree& p, double radius,
                                       const F& f) {
  walk::nearest<Lanes>(nodes, p, radius, f);
}

}  // namespace geom
