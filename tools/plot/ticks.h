#pragma once

// Where the marks of an axis stand.

#include <vector>

namespace plot {

// Round values (1, 2 or 5 times a power of ten) inside [low, high], about `count` of them.
std::vector<double> ticks(double low, double high, int count);

}  // namespace plot
