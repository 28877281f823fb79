#include "geom/picture/grid_lines.h"

#include <algorithm>
#include <cmath>

namespace geom::picture {
namespace {

constexpr double kFewestCells = 6;
constexpr double kSmallest = 0.01;  // metres: of a region that is nearly a point

}  // namespace

double round_length(double length) {
  // A little over, so that the logarithm of 1000 is never 2.9999…
  const double power = std::pow(10, std::floor(std::log10(length * (1 + 1e-12))));
  const double lead = length * (1 + 1e-12) / power;
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

GridLines grid_lines(const Aabb& region) {
  const double side = (region.max - region.min).head<2>().maxCoeff();
  const double cell = round_length(std::max(side / kFewestCells, kSmallest));
  return {cell, cell / 10};
}

}  // namespace geom::picture
