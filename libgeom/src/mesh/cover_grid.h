#pragma once

// The cells that triangles are cut by, and how exact the cutting is.

#include <algorithm>
#include <cmath>

namespace geom {

// Cells [first, last).
struct CellRange {
  long first = 0;
  long last = 0;
};

// Cell k is the closed interval from at(k) to at(k + 1), on either axis: neighbours share a side.
struct CoverGrid {
  double pitch = 0;  // metres
  double rise = 0;   // metres: how far heights of a run may be from those of its cells
  double reach = 0;  // metres: more than all rounding when a triangle is cut

  // With both, no point of a box over a cell is further from the surface in that cell than
  // hypot(sqrt(2) (pitch + 2 reach), rise + 2 reach) < 0.998 slack. Coordinates are at most
  // `largest`, and the slack at least 1e-9 of it.
  static CoverGrid of(double slack, double largest) {
    constexpr double kUnit = 0x1p-53;  // of rounding
    return {0.625 * slack, 0.46 * slack, 64 * kUnit * std::max(largest, slack)};
  }

  double at(long k) const { return static_cast<double>(k) * pitch; }

  // The last cell that begins at or below `v`, and the first that ends at or above: division may
  // be one off.
  long last_from(double v) const {
    auto k = static_cast<long>(std::floor(v / pitch));
    while (at(k) > v) --k;
    while (at(k + 1) <= v) ++k;
    return k;
  }
  long first_to(double v) const {
    auto k = static_cast<long>(std::ceil(v / pitch)) - 1;
    while (at(k + 1) < v) ++k;
    while (at(k) >= v) --k;
    return k;
  }

  // As few cells as hold all from `low` to `high`.
  CellRange around(double low, double high) const {
    const long first = last_from(low);
    return {first, std::max(first, first_to(high)) + 1};
  }
};

}  // namespace geom
