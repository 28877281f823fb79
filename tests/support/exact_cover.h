#pragma once

// That a cover holds its polygon, proved in rational numbers: no points are tried.

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/shape/cover.h"
#include "support/exact_oracle.h"

namespace oracle {

struct ExactPoint {
  Q x;
  Q y;
};

inline ExactPoint exact(const geom::Vec2& p) { return {Q(p.x()), Q(p.y())}; }

// By the polygon's own definition, for points off its edges; `p` on an edge may give either.
inline bool exactly_inside(const geom::Polygon& polygon, const ExactPoint& p) {
  bool odd = false;
  const auto winding = [&](const std::vector<geom::Vec2>& ring) {
    int turns = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ExactPoint a = exact(ring[i]);
      const ExactPoint b = exact(ring[(i + 1) % ring.size()]);
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const bool up = b.y > p.y;
      const Q side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      if (up ? side <= 0 : side >= 0) continue;
      turns += up ? 1 : -1;
      odd = !odd;
    }
    return turns;
  };
  const bool in_outer = winding(polygon.outer) != 0;
  bool in_hole = false;
  for (const auto& hole : polygon.holes) in_hole |= winding(hole) != 0;
  return odd || (in_outer && !in_hole);
}

// Whether the closed segment lies within the union of the closed rectangles.
inline bool segment_covered(const geom::Vec2& a, const geom::Vec2& b,
                            const std::vector<geom::Rectangle>& rectangles) {
  std::vector<std::pair<Q, Q>> parts;
  for (const geom::Rectangle& r : rectangles) {
    Q first = 0;
    Q last = 1;
    bool meets = true;
    for (int i = 0; i < 2 && meets; ++i) {
      if (std::max(a[i], b[i]) < r.min[i] || std::min(a[i], b[i]) > r.max[i]) meets = false;
      const Q d = Q(b[i]) - Q(a[i]);
      if (!meets || d == 0) continue;
      Q u = (Q(r.min[i]) - Q(a[i])) / d;
      Q v = (Q(r.max[i]) - Q(a[i])) / d;
      if (u > v) std::swap(u, v);
      first = std::max(first, u);
      last = std::min(last, v);
    }
    if (meets && first <= last) parts.emplace_back(first, last);
  }
  std::sort(parts.begin(), parts.end());
  Q reached = 0;
  bool any = false;
  for (const auto& [first, last] : parts) {
    if (first > reached) return false;
    reached = std::max(reached, last);
    any = true;
  }
  return any && reached >= 1;
}

// Whether every point of the closed polygon lies within the closed rectangles. Its edges do, and no
// open cell between the rectangles' sides that none of them covers lies inside: an edge cannot
// enter such a cell, so its middle speaks for it.
inline bool exactly_covered(const geom::Polygon& polygon,
                            const std::vector<geom::Rectangle>& rectangles) {
  const auto ring_covered = [&](const std::vector<geom::Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!segment_covered(ring[i], ring[(i + 1) % ring.size()], rectangles)) return false;
    }
    return true;
  };
  if (!ring_covered(polygon.outer)) return false;
  for (const auto& hole : polygon.holes) {
    if (!ring_covered(hole)) return false;
  }
  std::vector<double> xs;
  std::vector<double> ys;
  for (const geom::Rectangle& r : rectangles) {
    xs.insert(xs.end(), {r.min.x(), r.max.x()});
    ys.insert(ys.end(), {r.min.y(), r.max.y()});
  }
  for (auto* side : {&xs, &ys}) {
    std::sort(side->begin(), side->end());
    side->erase(std::unique(side->begin(), side->end()), side->end());
  }
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    std::vector<int> depth(xs.size());
    for (const geom::Rectangle& r : rectangles) {
      if (r.min.y() > ys[j] || r.max.y() < ys[j + 1]) continue;
      ++depth[std::lower_bound(xs.begin(), xs.end(), r.min.x()) - xs.begin()];
      --depth[std::lower_bound(xs.begin(), xs.end(), r.max.x()) - xs.begin()];
    }
    int over = 0;
    bool was_free = false;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      over += depth[i];
      const bool free = over == 0;
      // Free neighbours of a row share an open side, so the first speaks for them.
      if (free && !was_free &&
          exactly_inside(polygon, {(Q(xs[i]) + Q(xs[i + 1])) / 2, (Q(ys[j]) + Q(ys[j + 1])) / 2})) {
        return false;
      }
      was_free = free;
    }
  }
  return true;
}

}  // namespace oracle
