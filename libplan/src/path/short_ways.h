#pragma once

// Where paths between two places may go that are shorter than a given length.

#include <algorithm>
#include <cmath>

#include "geom/shape/aabb.h"

namespace plan {

using geom::Vec3;

// The places whose distances from both ends add up to less than `length`: the inside of a prolate
// spheroid with the ends as foci.
struct ShortWays {
  Vec3 from;
  Vec3 to;
  double length;  // metres

  bool hold(const Vec3& p) const { return (p - from).norm() + (to - p).norm() < length; }

  // False only where they hold no place of the box.
  bool may_meet(const geom::Aabb& box) const {
    return geom::distance(from, box) + geom::distance(to, box) < length;
  }

  // A box that holds all of them, up to rounding; flat where there are none.
  geom::Aabb around() const;
};

inline geom::Aabb ShortWays::around() const {
  const Vec3 way = to - from;
  const double square = way.squaredNorm();
  const double across = std::max(0.0, length * length - square) / 4;  // half widths, squared
  Vec3 reach;
  for (int k = 0; k < 3; ++k) {
    reach[k] = std::sqrt(across + way[k] * way[k] / 4);
  }
  const Vec3 middle = 0.5 * (from + to);
  return {middle - reach, middle + reach};
}

}  // namespace plan
