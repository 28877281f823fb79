#pragma once

// Random parts of edges, labels along them, and what a label says of a point, by trying.

#include <algorithm>
#include <limits>

#include "bound/line_label.h"
#include "support/random_city.h"

namespace plan::testing {

inline EdgePart random_part(support::Random& random, double size) {
  EdgePart part;
  for (int k = 0; k < 3; ++k) part.low[k] = random.stepped(0, size, 0.5);
  part.high = part.low;
  const int axis = random.below(4);
  if (axis == 3) return part;
  part.axis = static_cast<std::uint8_t>(axis);
  part.high[axis] += random.stepped(0.25, 3, 0.25);
  part.outward = {1, 1};
  return part;
}

// As a path can give it: no steeper than the part is long.
inline LineLabel random_label(support::Random& random, const EdgePart& part) {
  const double low = random.uniform(0, 10);
  return {low, low + random.uniform(-1, 1) * part.length()};
}

inline Vec3 at(const EdgePart& part, double t) { return part.low + t * (part.high - part.low); }

inline double at(const LineLabel& label, double t) { return label.low * (1 - t) + label.high * t; }

// The least sum over so many places of the part: no less than the least of all.
inline double best_over(const EdgePart& part, const LineLabel& label, const Vec3& q, int places) {
  double best = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= places; ++n) {
    const double t = static_cast<double>(n) / places;
    best = std::min(best, at(label, t) + (q - at(part, t)).norm());
  }
  return best;
}

}  // namespace plan::testing
