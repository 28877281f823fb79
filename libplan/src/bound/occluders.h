#pragma once

// Convex pieces of what is blocked, and whether one of them stands between two parts of edges.
//
// An occluder is a box inside the union of the closed grown boxes: a grown box made longer through
// others that hold its whole cross-section there. A segment that meets the inside of an occluder
// meets the inside of the union, so it is in no path. Each occluder is shrunk on every side by
// 2^-47 of the largest coordinate of it and the bounds. A segment is said to meet what is left
// where the slab test says so in rounded numbers. Its fractions of the segment are wrong by 4
// roundings and so the places by 2^-50 of that coordinate at most: the segment does meet the inside
// of the whole occluder.

#include <array>
#include <cstdint>
#include <vector>

#include "convex_edges.h"
#include "median_tree.h"

namespace plan {

// Occluders that hid something from a part, the last one first: they are tried first.
using Hints = std::array<std::uint32_t, 4>;
inline constexpr std::uint32_t kNoHint = ~std::uint32_t{0};
inline constexpr Hints kNoHints{kNoHint, kNoHint, kNoHint, kNoHint};

// clear: no occluder meets the segment between the middles, so none hides pieces from each other
// that the middles belong to.
enum class View : std::uint8_t { hidden, partial, clear };

class Occluders {
 public:
  explicit Occluders(const geom::CollisionScene& scene);

  std::size_t size() const { return boxes_.size(); }
  const geom::Aabb& box(std::uint32_t i) const { return boxes_[i]; }  // shrunk

  // Whether one occluder meets every segment from a point of `a` to a point of `b`: it does where
  // it meets the four from end to end, for the points of a line from which the segments to one
  // point meet a convex set are an interval. The occluder becomes the first of the hints.
  View between(const EdgePart& a, const EdgePart& b, Hints& hints) const;
  // Whether one of the hints does; or meets every segment to a box.
  bool hinted(const EdgePart& a, const EdgePart& b, Hints& hints) const;
  bool hinted(const EdgePart& a, const geom::Aabb& b, Hints& hints) const;

 private:
  template <class AllMeet>
  bool first_of(Hints& hints, const AllMeet& all_meet) const;
  void arrange();
  bool is_inside_another(std::uint32_t i) const;

  std::vector<geom::Aabb> boxes_;  // in the order of the tree
  MedianTree tree_;
};

}  // namespace plan
