#pragma once

// Where a shortest path may bend: convex edges of the union of the grown boxes, and bare corners.
//
// Let W be what is left of the free bounds (CollisionScene::free_bounds(), no axis of length 0)
// once the inside of the union of the closed grown boxes is taken away. Paths in W may touch.
// docs/bound.md proves that a shortest path in W bends only
// - at points of edges of which one quadrant around is in a box and both next to it are not, coming
//   from one of these two quadrants (closed) and leaving to the other; or
// - at corners that are not plain(): where edges of several boxes cross or are flush.
// Coordinates are only compared and copied here, so nothing is rounded.

#include <array>
#include <cstdint>
#include <vector>

#include "geom/collision/collision.h"

namespace plan {

using geom::Vec3;

inline constexpr std::uint8_t kCorner = 3;  // in place of an axis

// A closed stretch of an edge, or a corner (low == high).
struct EdgePart {
  Vec3 low;  // low and high differ along the axis alone
  Vec3 high;
  std::uint8_t axis = kCorner;
  // Signs, of the next two axes: the box is where both coordinates times these are less.
  std::array<std::int8_t, 2> outward{};

  bool is_corner() const { return axis == kCorner; }
  double length() const { return is_corner() ? 0 : high[axis] - low[axis]; }
};

// Bit 0: some of `other` is in the quadrant (out, in) of the edge's axes, closed; bit 1: in (in,
// out). 3 of a corner, which has no sides. 0 where all of `other` is on the edge's own line: no
// path bends there between the two.
inline int sides(const EdgePart& edge, const EdgePart& other) {
  if (edge.is_corner()) return 3;
  bool out[2];
  bool in[2];
  bool on_line = true;
  for (int n = 0; n < 2; ++n) {
    const int i = (edge.axis + 1 + n) % 3;
    const double at = edge.low[i];
    const bool low = other.low[i] <= at;
    const bool high = other.high[i] >= at;
    out[n] = edge.outward[n] > 0 ? high : low;
    in[n] = edge.outward[n] > 0 ? low : high;
    on_line = on_line && other.low[i] == at && other.high[i] == at;
  }
  return on_line ? 0 : (out[0] && in[1] ? 1 : 0) | (in[0] && out[1] ? 2 : 0);
}

// Bit 4 a + 2 b + c of the octants around a point: where x is larger (a = 1), y, z; set where
// it is in a box or out of bounds. Whether no shortest path bends at such a point but as at an edge
// through it.
bool plain(unsigned octants);

// Whole stretches, and corners that are not plain, in an order that depends on the map alone.
std::vector<EdgePart> convex_edges(const geom::CollisionScene& scene);

// The stretches cut into the fewest equal parts of at most `most` metres.
std::vector<EdgePart> parts_of(const std::vector<EdgePart>& edges, double most);

// The parts of one.
void cut(const EdgePart& edge, std::size_t parts, std::vector<EdgePart>& out);

}  // namespace plan
