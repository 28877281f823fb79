#include "held_parts.h"

#include <algorithm>
#include <cmath>

#include "geom/base/rounding.h"

namespace geom {
namespace {

// Shares of the stretch.
struct Span {
  double from = 0;
  double to = 1;

  bool empty() const { return from > to; }

  // Keeps where what runs from a to b along the stretch is from low to high.
  void clip(double a, double b, double low, double high) {
    if (a == b) {
      if (a < low || a > high) to = -1;
      return;
    }
    const double u = (low - a) / (b - a);
    const double v = (high - a) / (b - a);
    from = std::max(from, std::min(u, v));
    to = std::min(to, std::max(u, v));
  }
};

double largest(const WallStretch& s) {
  double out = std::max(std::abs(s.from.top), std::abs(s.to.top));
  for (const Vec2* p : {&s.from.near, &s.from.far, &s.to.near, &s.to.far}) {
    out = std::max(out, p->cwiseAbs().maxCoeff());
  }
  return out;
}

// Where the near side, and with `both` the far one, too, is in the box, whose sides are moved
// outward by `pad`; and where the upper edge and `rise` above it are not higher.
Span span_in(const Aabb& box, const WallStretch& s, bool both, double pad, double rise) {
  Span out;
  for (int i = 0; i < 2 && !out.empty(); ++i) {
    out.clip(s.from.near[i], s.to.near[i], box.min[i] - pad, box.max[i] + pad);
    if (both) out.clip(s.from.far[i], s.to.far[i], box.min[i] - pad, box.max[i] + pad);
  }
  const double top = box.max.z() + pad - rise;
  if (!out.empty()) out.clip(s.from.top, s.to.top, std::min(s.from.top, s.to.top), top);
  if (std::min(s.from.top, s.to.top) > top || box.min.z() > s.bottom) out.to = -1;
  return out;
}

}  // namespace

std::vector<Held> held_parts(const WallStretch& stretch, std::size_t count, double rise,
                             std::span<const Aabb> boxes) {
  std::vector<Held> out(count, Held::no);
  const double pad = 64 * ulp(largest(stretch));
  const auto parts = static_cast<double>(count);
  const auto at = [&](double k) { return out.begin() + static_cast<std::ptrdiff_t>(k); };
  for (const Aabb& box : boxes) {
    const Span may = span_in(box, stretch, false, pad, 0);
    if (may.empty()) continue;
    const auto last = at(std::min(parts, std::floor(may.to * parts) + 1));
    for (auto part = at(std::ceil(may.from * parts)); part < last; ++part) {
      *part = std::max(*part, Held::perhaps);
    }
    const Span surely = span_in(box, stretch, true, -pad, rise);
    if (surely.empty()) continue;
    const auto end = at(std::floor(surely.to * parts));
    for (auto part = at(std::ceil(surely.from * parts)); part < end; ++part) *part = Held::yes;
  }
  return out;
}

}  // namespace geom
