#pragma once

// Where a path may go on from a bend.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "bend_tree.h"
#include "bends.h"

namespace plan {

// How far a turn may miss wrapping: bends stand in for their part.
constexpr double kLoose = 0.08;

// Where a path may leave a bend that it came to from a direction, as tangent() and wraps() have it:
// a quadrant across the box edge, less what is on the near side of a line. They forgive a
// millimetre, so this forgives more.
class Onward {
 public:
  static constexpr double kForgiven = 4e-3;  // m

  Onward(const Bend& bend, const Across& in)
      : bend_(bend),
        first_axis_((bend.axis + 1) % 3),
        second_axis_((bend.axis + 2) % 3),
        second_(!in.second_side()) {
    ratio_ = second_ ? std::max(0.0, in.ratio() - kLoose) : std::min(1.0, in.ratio() + kLoose);
  }

  // What goes() compares, for a look at several directions at once.
  struct Terms {
    int first_axis;
    int second_axis;
    std::array<double, 2> outward;
    bool second_side;
    double ratio;
  };
  Terms terms() const {
    return {first_axis_,
            second_axis_,
            {1.0 * bend_.outward[0], 1.0 * bend_.outward[1]},
            second_,
            ratio_};
  }

  // Whether a path may leave in a direction, without a branch: of many that are asked, half may.
  bool goes(const Vec3& direction) const {
    const Across out{direction[first_axis_] * bend_.outward[0],
                     direction[second_axis_] * bend_.outward[1]};
    const double second = std::abs(out.y);
    const double share = ratio_ * (std::abs(out.x) + second);
    return (out.second_side() == second_) & out.tangent() &
           (second_ ? second >= share : second <= share);
  }

  // Whether none of the node's bends can be where.
  bool misses(const BendTree::Node& node) const {
    const auto [x0, x1] = range(node, 0);
    const auto [y0, y1] = range(node, 1);
    if (second_ ? x1 < -kForgiven || y0 > kForgiven : x0 > kForgiven || y1 < -kForgiven)
      return true;
    return ratio_ * x0 + (1 - ratio_) * y0 > kForgiven;
  }

 private:
  // Along the first or second axis across, outward from the bend.
  std::pair<double, double> range(const BendTree::Node& node, int which) const {
    const int k = which == 0 ? first_axis_ : second_axis_;
    const double low = node.min[k] - bend_.position[k];
    const double high = node.max[k] - bend_.position[k];
    return bend_.outward[static_cast<std::size_t>(which)] > 0 ? std::pair(low, high)
                                                              : std::pair(-high, -low);
  }

  const Bend& bend_;
  int first_axis_;  // across the box edge
  int second_axis_;
  bool second_;   // side to leave on
  double ratio_;  // of Across, at most on the first side, at least on the second
};

}  // namespace plan
