#pragma once

// What is asked of a tree, in its frame and in single precision.

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

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
  // Whoever is between a child's planes for this part of the segment and more surely meets the box.
  float sure = std::numeric_limits<float>::infinity();
  bool outside = false;  // beyond all boxes

  SegmentInTree(const TreeFrame& frame, const Vec3& a, const Vec3& b) {
    if (contains(frame.reach, a) && contains(frame.reach, b)) {
      set(frame, a, b);
      // A place is wrong by less than half the pad (TreeFrame), and a plane lies at most 1.2 pads
      // outside of its box: 3.4 pads at both ends, along the axis where that takes longest.
      const float slowest =
          std::max(std::max(std::abs(inverse[0]), std::abs(inverse[1])), std::abs(inverse[2]));
      sure = static_cast<float>(4 * frame.pad) * slowest;
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

// A region in the frame of a tree. It may be infinite. The nearest numbers do: planes are padded by
// more than roundings lose.
struct RegionInTree {
  std::array<float, 3> low;
  std::array<float, 3> high;
  float sure;  // below 0: what reaches this far between a child's planes surely meets the box

  RegionInTree(const TreeFrame& frame, const Aabb& region)
      : sure(static_cast<float>(-2 * frame.pad)) {
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      low[k] = static_cast<float>(std::max(region.min[i], frame.reach.min[i]) - frame.corner[i]);
      high[k] = static_cast<float>(std::min(region.max[i], frame.reach.max[i]) - frame.corner[i]);
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

}  // namespace geom
