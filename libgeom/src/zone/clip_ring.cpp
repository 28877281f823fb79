#include "clip_ring.h"

namespace geom::zone {
namespace {

// Keeps the side of a line on which sign * p[axis] <= sign * at.
std::vector<Vec2> half(const std::vector<Vec2>& ring, int axis, double sign, double at) {
  std::vector<Vec2> out;
  const auto inside = [&](const Vec2& p) { return sign * p[axis] <= sign * at; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if (inside(a)) out.push_back(a);
    if (inside(a) == inside(b)) continue;
    Vec2 cut = a + (b - a) * ((at - a[axis]) / (b[axis] - a[axis]));
    cut[axis] = at;
    out.push_back(cut);
  }
  return out;
}

}  // namespace

std::vector<Vec2> clipped(std::vector<Vec2> ring, const Rectangle& within) {
  for (int axis = 0; axis < 2; ++axis) {
    ring = half(ring, axis, 1, within.max[axis]);
    ring = half(ring, axis, -1, within.min[axis]);
  }
  return ring;
}

Polygon clipped(const Polygon& polygon, const Rectangle& within) {
  Polygon out{.outer = clipped(polygon.outer, within), .holes = {}};
  if (out.outer.empty()) return out;
  for (const std::vector<Vec2>& hole : polygon.holes) {
    std::vector<Vec2> part = clipped(hole, within);
    if (part.size() >= 3) out.holes.push_back(std::move(part));
  }
  return out;
}

}  // namespace geom::zone
