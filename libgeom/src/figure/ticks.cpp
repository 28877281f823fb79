#include "geom/figure/ticks.h"

#include <cmath>

namespace geom::figure {

std::vector<double> ticks(double low, double high, int count) {
  const double raw = (high - low) / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = power * (lead < 1.5 ? 1 : lead < 3 ? 2 : lead < 7 ? 5 : 10);
  std::vector<double> values;
  for (double k = std::ceil(low / step); k * step <= high + step * 1e-9; ++k) {
    values.push_back(k * step + 0.0);
  }
  return values;
}

}  // namespace geom::figure
