#pragma once

// The way between the middles of two parts: a lower bound on all ways between them that is carried
// on with five additions.
//
// With c and C the middles of two parts, h and H half their lengths along their axes and u the
// direction from c to C, what line_label.h says of u is, for a label of the first part,
//   min over x of label(x) + |q - x|  >=  |C - c| + min(low + h u_i, high - h u_i) + u . (q - C),
// a line over the second part: least or most H u_j less at its ends. It touches where x and q are
// the middles, and is the worse the nearer the parts are, so it serves to see that a link lowers no
// label and that no short path uses it. What does is carried exactly.
//
// Rounding: a part's half length times the direction, as a float, is wrong by 2^-23 of the half
// length at most. That, and `slack` for all else (line_label.h), is taken off |C - c|, which is
// rounded down.

#include <algorithm>
#include <cmath>
#include <limits>

#include "convex_edges.h"
#include "line_label.h"

namespace plan {

struct Tangent {
  float length = 0;  // metres: between the middles
  float here = 0;    // half of the first part's length, times what the direction has of its axis
  float there = 0;   // … of the second part's

  // From a label of the first part to the second.
  LineLabel forward(const LineLabel& label) const {
    const double middle = length + std::min(label.low + here, label.high - here);
    return {middle - there, middle + there};
  }
  // From a label of the second part to the first.
  LineLabel backward(const LineLabel& label) const {
    const double middle = length + std::min(label.low - there, label.high + there);
    return {middle + here, middle - here};
  }
};

inline Tangent tangent(const EdgePart& from, const EdgePart& to, double slack) {
  const Vec3 way = 0.5 * ((to.low - from.low) + (to.high - from.high));
  const double length = way.norm();
  Tangent out;
  double halves = 0;
  if (length > 0) {
    const auto along = [&](const EdgePart& part) {
      const double half = 0.5 * part.length();
      halves += half;
      return part.is_corner() ? 0.0F : static_cast<float>(half * way[part.axis] / length);
    };
    out.here = along(from);
    out.there = along(to);
  }
  const double least = length - halves * 0x1p-23 - slack;
  out.length = static_cast<float>(least);
  if (out.length > least) {
    out.length = std::nextafter(out.length, -std::numeric_limits<float>::infinity());
  }
  return out;
}

}  // namespace plan
