#include "geom/figure/histogram.h"

#include <algorithm>
#include <cmath>

namespace geom::figure {
namespace {

double round_width(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double lead : {1.0, 2.0, 5.0}) {
    if (least <= lead * power * (1 + 1e-9)) return lead * power;
  }
  return 10 * power;
}

}  // namespace

std::size_t Histogram::most() const { return *std::max_element(counts.begin(), counts.end()); }

Histogram histogram(std::span<const double> values, int wanted) {
  Histogram out;
  out.counts.assign(1, 0);
  if (values.empty()) return out;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double size = std::max(std::abs(*low), std::abs(*high));
  const double reach = *high > *low ? std::max(*high - *low, 1e-9 * size) : std::max(1.0, size);
  out.width = round_width(reach / wanted);
  out.low = std::floor(*low / out.width) * out.width;
  const double bins = std::floor((*high - out.low) / out.width) + 1;
  out.counts.assign(static_cast<std::size_t>(bins), 0);
  for (const double value : values) {
    const double at = std::floor((value - out.low) / out.width);
    ++out.counts[static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1))];
  }
  return out;
}

}  // namespace geom::figure
