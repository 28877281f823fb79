#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include "shape/simple_ring.h"

namespace geom {

bool is_simple(std::span<const Vec2> ring) {
  if (ring.size() < 3) return false;
  CGAL::Polygon_2<CGAL::Exact_predicates_inexact_constructions_kernel> polygon;
  for (const Vec2& p : ring) polygon.push_back({p.x(), p.y()});
  return polygon.is_simple();
}

}  // namespace geom
