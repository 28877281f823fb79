#pragma once

// Where the marks of an axis stand.
//
// Example:
//   assert(geom::figure::ticks(0, 10, 5).size() == 6);  // 0, 2, 4, 6, 8, 10

#include <vector>

namespace geom::figure {

// Round values (1, 2 or 5 times a power of ten) inside [low, high], about `count` of them.
std::vector<double> ticks(double low, double high, int count);

}  // namespace geom::figure
