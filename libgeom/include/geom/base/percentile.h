#pragma once

// Percentiles by nearest rank.
//
// Example:
//   assert(geom::percentile({3, 1, 2}, 0.5) == 2);

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geom {

// The least value that at least `share` of the values, in (0, 1], do not exceed. At least one
// value; none is NaN.
inline double percentile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace geom
