#pragma once

// What intervals leave of a line: the exposed stretches of a box edge.

#include <algorithm>
#include <utility>
#include <vector>

namespace plan {

using Interval = std::pair<double, double>;  // from, to; closed

// The stretches of [low, high] of which no inner point is in an interval, in order. Stretches of no
// length are left out, except [low, low] itself where low == high and nothing begins below it.
inline std::vector<Interval> uncovered(double low, double high, std::vector<Interval> covered) {
  std::sort(covered.begin(), covered.end());
  std::vector<Interval> out;
  for (const auto& [from, to] : covered) {
    if (from > low) out.push_back({low, std::min(from, high)});
    low = std::max(low, to);
    if (low >= high) return out;
  }
  out.push_back({low, high});
  return out;
}

}  // namespace plan
