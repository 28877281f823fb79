#include "traj/fleet/departure_span.h"

#include <algorithm>

namespace traj {

std::vector<DepartureSpan> united(std::vector<DepartureSpan> spans) {
  std::sort(spans.begin(), spans.end(), [](const DepartureSpan& a, const DepartureSpan& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  std::size_t last = 0;
  for (std::size_t i = 1; i < spans.size(); ++i) {
    if (spans[i].low <= spans[last].high) {
      spans[last].high = std::max(spans[last].high, spans[i].high);
    } else {
      spans[++last] = spans[i];
    }
  }
  if (!spans.empty()) spans.resize(last + 1);
  return spans;
}

}  // namespace traj
