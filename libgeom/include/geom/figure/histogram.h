#pragma once

// How often values lie where: counts in bins of a round width.
//
// Example:
//   const std::vector<double> delays{0, 1, 1, 12};
//   const geom::figure::Histogram bars = geom::figure::histogram(delays, 10);
//   assert(bars.low <= 0 && bars.high() >= 12 && bars.most() >= 2);

#include <cstddef>
#include <span>
#include <vector>

namespace geom::figure {

// Bins side by side from `low` on, each half open, but the last closed.
struct Histogram {
  double low = 0;
  double width = 1;
  std::vector<std::size_t> counts;  // at least one

  double high() const { return low + width * static_cast<double>(counts.size()); }
  std::size_t most() const;
};

// Bins of a round width (1, 2 or 5 times a power of ten), about `wanted` of them (> 0), which begin
// at a multiple of it and hold all values. Of no values, or of one value alone: one bin.
Histogram histogram(std::span<const double> values, int wanted);

}  // namespace geom::figure
