#include "cover_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/shape/cover.h"
#include "shape/convex_parts.h"

namespace geom {
namespace {

constexpr std::size_t kMostCorners = 2000;  // that a surface is cut into convex parts for

using Ring = std::vector<Vec2>;

// The part of a convex ring where the plane is at most (sign 1) or at least (-1) a level.
Ring clipped(const Ring& ring, const PlaneFit& plane, double level, double sign) {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    const double below_a = sign * (level - plane(a));
    const double below_b = sign * (level - plane(b));
    if (below_a >= 0) out.push_back(a);
    if ((below_a >= 0) != (below_b >= 0)) {
      out.push_back(a + (b - a) * std::clamp(below_a / (below_a - below_b), 0.0, 1.0));
    }
  }
  return out;
}

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 step = b - a;
  const double squared = step.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(step) / squared, 0.0, 1.0) : 0;
  return (a + t * step - p).norm();
}

class SlopeCover {
 public:
  SlopeCover(const Footprint& footprint, const PlaneFit& plane, double slack, double margin)
      : footprint_(footprint),
        plane_(plane),
        steepness_(plane.gradient.norm()),
        margin_(margin),
        usable_(slack - 1.5 * margin - 1e-6 * slack - 4e-9),
        overlap_(overlap_of(slack)),
        step_(std::max(usable_ / std::sqrt(2.0) - 2 * plane.residual - overlap_, usable_ / 8)) {}

  std::vector<Aabb> cover() {
    const double rise = plane_.high - plane_.low;
    if (rise <= usable_ / 2) {
      add(geom::cover(footprint_.polygon, std::sqrt(usable_ * usable_ - rise * rise)), plane_.high);
    } else if (corner_count() > kMostCorners) {
      cover_cut();
    } else {
      for (const Ring& part : convex_parts(footprint_.polygon)) cover_part(part);
    }
    return std::move(boxes_);
  }

 private:
  std::size_t corner_count() const {
    std::size_t count = footprint_.polygon.outer.size();
    for (const auto& hole : footprint_.polygon.holes) count += hole.size();
    return count;
  }

  double top_at(double level) const { return std::min(level + plane_.residual, plane_.high); }

  void add(const std::vector<Rectangle>& rectangles, double top) {
    const Vec2 margin = Vec2::Constant(margin_);
    for (const Rectangle& r : rectangles) {
      const Vec2 low = r.min - margin;
      const Vec2 high = r.max + margin;
      boxes_.push_back({{low.x(), low.y(), footprint_.bottom}, {high.x(), high.y(), top}});
    }
  }

  // Level by level. Each point of a box is at most usable_ / sqrt 2 beside a point of the strip,
  // and the top no more than that above the surface there.
  void cover_part(const Ring& part) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec2& p : part) {
      low = std::min(low, plane_(p));
      high = std::max(high, plane_(p));
    }
    const bool steep = steepness_ > 1;
    double steps = 1;  // that the strip before took
    for (double level = low; level < high || level == low;) {
      double next = level + step_;
      std::vector<Rectangle> best = strip(part, level, next);
      for (double n = 2 * std::max(1.0, steps / 4); steep && next < high; n *= 2) {
        const double further = level + n * step_;
        std::vector<Rectangle> wider = strip(part, level, further);
        if (!within_slack(part, wider, top_at(further))) break;
        steps = n;
        next = further;
        best = std::move(wider);
      }
      add(best, top_at(std::min(next, high)));
      if (next >= high) break;
      level = next;
    }
  }

  std::vector<Rectangle> strip(const Ring& part, double from, double to) const {
    const Ring ring = clipped(clipped(part, plane_, from - overlap_, -1), plane_, to, 1);
    return geom::cover({ring, {}}, usable_ / std::sqrt(2.0));
  }

  bool within_slack(const Ring& part, const std::vector<Rectangle>& rectangles, double top) const {
    return std::all_of(rectangles.begin(), rectangles.end(), [&](const Rectangle& r) {
      for (int i = 0; i < 4; ++i) {
        const Vec3 corner(i % 2 ? r.max.x() : r.min.x(), i / 2 ? r.max.y() : r.min.y(), top);
        if (to_solid(part, corner) > usable_) return false;
      }
      return true;
    });
  }

  // From p to what is surely below the surface over the part: no less than the true distance.
  double to_solid(const Ring& part, const Vec3& p) const {
    const auto floor = [&](const Vec2& q) { return plane_(q) - plane_.residual; };
    const Vec2 at = p.head<2>();
    double best = std::numeric_limits<double>::infinity();
    if (holds(part, at)) {
      const double above = p.z() - floor(at);
      if (above <= 0) return 0;
      best = above;
      const double square = 1 + steepness_ * steepness_;
      if (holds(part, at + plane_.gradient * (above / square))) {
        best = std::min(best, above / std::sqrt(square));
      }
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec2& a = part[i];
      const Vec2& b = part[(i + 1) % part.size()];
      const Vec3 from(a.x(), a.y(), floor(a));
      const Vec3 to(b.x(), b.y(), floor(b));
      best = std::min(best, to_segment(p, from, to));
      const Vec2 step = b - a;
      const double squared = step.squaredNorm();
      const Vec2 beside =
          squared > 0 ? a + step * std::clamp((at - a).dot(step) / squared, 0.0, 1.0) : a;
      if (floor(beside) >= p.z()) best = std::min(best, (beside - at).norm());
    }
    return best;
  }

  // Of a convex ring that runs counter-clockwise.
  static bool holds(const Ring& part, const Vec2& p) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec2 step = part[(i + 1) % part.size()] - part[i];
      const Vec2 to = p - part[i];
      if (step.x() * to.y() - step.y() * to.x() < 0) return false;
    }
    return part.size() > 2;
  }

  // The rectangles of the polygon, each cut where the plane has risen: a point at most s beside the
  // polygon is at most s times the steepness higher than there.
  void cover_cut() {
    const double aside = usable_ / (2 * (1 + steepness_));
    const double rise = std::max(usable_ / 2 - 2 * plane_.residual, usable_ / 8) / 2;
    for (const Rectangle& r : geom::cover(footprint_.polygon, aside)) {
      const Vec2 size = r.max - r.min;
      const Vec2 over = plane_.gradient.cwiseAbs().cwiseProduct(size);
      const auto parts = [&](double v) { return std::max(1.0, std::ceil(v / rise)); };
      const double columns = parts(over.x());
      const double rows = parts(over.y());
      for (double j = 0; j < rows; ++j) {
        for (double i = 0; i < columns; ++i) {
          const Vec2 low = r.min + size.cwiseProduct(Vec2(i / columns, j / rows));
          const Vec2 high = r.min + size.cwiseProduct(Vec2((i + 1) / columns, (j + 1) / rows));
          add_cell({low, high});
        }
      }
    }
  }

  void add_cell(const Rectangle& r) {
    const double level =
        plane_(0.5 * (r.min + r.max)) + 0.5 * plane_.gradient.cwiseAbs().dot(r.max - r.min);
    add({r}, top_at(level));
  }

  const Footprint& footprint_;
  const PlaneFit& plane_;
  double steepness_;
  double margin_;
  double usable_;  // of the slack
  double overlap_;
  double step_;
  std::vector<Aabb> boxes_;
};

}  // namespace

std::vector<Aabb> cover_slope(const Footprint& footprint, const PlaneFit& plane, double slack,
                              double margin) {
  return SlopeCover(footprint, plane, slack, margin).cover();
}

double overlap_of(double slack) { return slack / 12; }

}  // namespace geom
