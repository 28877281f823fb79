#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "orientation.h"

namespace geom {

int exact_orientation(double ax, double ay, double bx, double by, double cx, double cy) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by),
                           Kernel::Point_2(cx, cy));
}

}  // namespace geom
