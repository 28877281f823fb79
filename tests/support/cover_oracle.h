#pragma once

// What a cover promises, tried in other ways than it is made.

#include <algorithm>
#include <queue>

#include "geom/shape/cover.h"

namespace oracle {

using geom::Polygon;
using geom::Rectangle;
using geom::Vec2;

inline bool covered(const std::vector<Rectangle>& rectangles, const Vec2& p) {
  return std::any_of(rectangles.begin(), rectangles.end(), [&](const Rectangle& r) {
    return (p.array() >= r.min.array()).all() && (p.array() <= r.max.array()).all();
  });
}

// Distance by rays and feet in long double, all rings by the polygon's own definition.
class Distance {
 public:
  explicit Distance(const Polygon& polygon) : polygon_(polygon) {}

  long double operator()(long double x, long double y) const {
    return std::max(0.0L, signed_at(x, y));
  }

  // Inside it is negative, and its size is the distance to the edges.
  long double signed_at(long double x, long double y) const {
    int crossings = 0;
    bool in_hole = false;
    long double best = 1e30L;
    const int outer = look(polygon_.outer, x, y, crossings, best);
    for (const auto& hole : polygon_.holes) in_hole |= look(hole, x, y, crossings, best) != 0;
    return crossings % 2 == 1 || (outer != 0 && !in_hole) ? -best : best;
  }

  // No point of the rectangle is further from the polygon: the distance to one edge is greatest at
  // a corner, since it is convex.
  long double at_most(const Rectangle& r) const {
    long double best = 1e30L;
    const auto try_ring = [&](const std::vector<Vec2>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        long double furthest = 0;
        for (const long double x : {r.min.x(), r.max.x()}) {
          for (const long double y : {r.min.y(), r.max.y()}) {
            furthest = std::max(furthest, to_edge(ring[i], ring[(i + 1) % ring.size()], x, y));
          }
        }
        best = std::min(best, furthest);
      }
    };
    try_ring(polygon_.outer);
    for (const auto& hole : polygon_.holes) try_ring(hole);
    return best;
  }

 private:
  static long double to_edge(const Vec2& a, const Vec2& b, long double x, long double y) {
    const long double dx = static_cast<long double>(b.x()) - a.x();
    const long double dy = static_cast<long double>(b.y()) - a.y();
    const long double square = dx * dx + dy * dy;
    long double t = square > 0 ? ((x - a.x()) * dx + (y - a.y()) * dy) / square : 0;
    t = std::clamp(t, 0.0L, 1.0L);
    return std::hypot(a.x() + t * dx - x, a.y() + t * dy - y);
  }

  static int look(const std::vector<Vec2>& ring, long double x, long double y, int& crossings,
                  long double& best) {
    int turns = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      best = std::min(best, to_edge(a, b, x, y));
      if ((a.y() > y) == (b.y() > y)) continue;
      const long double dy = static_cast<long double>(b.y()) - a.y();
      if (a.x() + (y - a.y()) / dy * (static_cast<long double>(b.x()) - a.x()) <= x) continue;
      turns += dy > 0 ? 1 : -1;
      ++crossings;
    }
    return turns;
  }

  const Polygon& polygon_;
};

// The furthest that any point of the rectangle lies from the polygon, to `tolerance`: best first by
// two bounds, that distance grows no faster than one goes and that of the nearest edge. Where all
// of it lies within `least`, that is the answer: small rectangles deep inside are not cut to dust.
inline double furthest_outside(const Polygon& polygon, const Rectangle& r, double tolerance,
                               double least = 0) {
  const Distance distance(polygon);
  struct Piece {
    long double bound;
    Rectangle r;
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };
  long double best = least;
  std::priority_queue<Piece> open;
  const auto push = [&](const Rectangle& piece) {
    const Vec2 c = 0.5 * (piece.min + piece.max);
    const long double d = distance.signed_at(c.x(), c.y());
    best = std::max(best, d);
    for (const double x : {piece.min.x(), piece.max.x()}) {
      for (const double y : {piece.min.y(), piece.max.y()}) best = std::max(best, distance(x, y));
    }
    open.push(
        {std::min(d + 0.5L * (piece.max - piece.min).norm(), distance.at_most(piece)), piece});
  };
  push(r);
  while (open.top().bound > best + tolerance) {
    const Rectangle top = open.top().r;
    open.pop();
    const Vec2 size = top.max - top.min;
    const int axis = size.x() >= size.y() ? 0 : 1;
    Rectangle low = top;
    Rectangle high = top;
    low.max[axis] = high.min[axis] = 0.5 * (top.min[axis] + top.max[axis]);
    push(low);
    push(high);
  }
  return static_cast<double>(std::max(best, open.top().bound));
}

}  // namespace oracle
