#include "geom/shape/polygon.h"

#include <algorithm>
#include <limits>

#include "orientation.h"

namespace geom {
namespace {

// How often the ring runs around p, counter-clockwise; p on the ring counts as outside.
int winding(const std::vector<Vec2>& ring, const Vec2& p, int& crossings) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    const bool up = b.y() > p.y();
    const int side = orientation(a.x(), a.y(), b.x(), b.y(), p.x(), p.y());
    if ((up && side <= 0) || (!up && side >= 0)) continue;
    turns += up ? 1 : -1;
    ++crossings;
  }
  return turns;
}

double distance_to_ring(const std::vector<Vec2>& ring, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2 d = ring[(i + 1) % ring.size()] - a;
    const double square = d.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(d) / square, 0.0, 1.0) : 0;
    best = std::min(best, (a + t * d - p).norm());
  }
  return best;
}

}  // namespace

bool contains(const Polygon& polygon, const Vec2& p) {
  int crossings = 0;
  const bool in_outer = winding(polygon.outer, p, crossings) != 0;
  bool in_hole = false;
  for (const auto& hole : polygon.holes) in_hole |= winding(hole, p, crossings) != 0;
  return crossings % 2 == 1 || (in_outer && !in_hole);
}

double distance(const Polygon& polygon, const Vec2& p) {
  if (contains(polygon, p)) return 0;
  double best = distance_to_ring(polygon.outer, p);
  for (const auto& hole : polygon.holes) best = std::min(best, distance_to_ring(hole, p));
  return best;
}

}  // namespace geom
