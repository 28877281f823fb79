#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

#include "orientation.h"

namespace geom {

int exact_orientation(double ax, double ay, double bx, double by, double cx, double cy) {
  // The kernel takes finite numbers alone. 0 is the sign that separates nothing.
  for (const double v : {ax, ay, bx, by, cx, cy}) {
    if (!std::isfinite(v)) return 0;
  }
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by),
                           Kernel::Point_2(cx, cy));
}

}  // namespace geom
