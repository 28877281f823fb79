#pragma once

// Nodes of a lattice around a point.

#include <algorithm>
#include <cmath>

#include "plan/lattice/lattice.h"

namespace plan {

// Calls f(index) for the nodes of a ring around p that the lattice has, the upper ones first, until
// it returns true; says whether it did. Ring 0 is the corners of the cell around p.
template <class F>
bool any_in_ring(const Lattice& lattice, const Vec3& p, std::int64_t ring, const F& f) {
  Index3 base;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double cells = (p[axis] - lattice.coordinate(axis, 0)) / lattice.spec().spacing;
    base[k] = static_cast<std::int64_t>(
        std::clamp(std::floor(cells), -1.0, static_cast<double>(lattice.dims()[k])));
  }
  const auto on_edge = [&](std::int64_t v) { return v == -ring || v == ring + 1; };
  for (std::int64_t k = ring + 1; k >= -ring; --k) {
    for (std::int64_t j = -ring; j <= ring + 1; ++j) {
      for (std::int64_t i = -ring; i <= ring + 1; ++i) {
        if (!on_edge(i) && !on_edge(j) && !on_edge(k)) continue;
        const Index3 index = {base[0] + i, base[1] + j, base[2] + k};
        if (lattice.grid().contains(index) && f(index)) return true;
      }
    }
  }
  return false;
}

}  // namespace plan
