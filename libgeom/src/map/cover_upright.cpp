#include "cover_upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cover_slope.h"
#include "geom/shape/cover.h"

namespace geom {
namespace {

constexpr double kMostParts = 1e6;  // of one stretch between two corners

// A stretch along the surface, and the range of its top.
struct Part {
  double from;
  double to;
  double low;
  double high;
};

class UprightCover {
 public:
  UprightCover(const Footprint& footprint, const PlaneFit& plane, double slack)
      : footprint_(footprint), plane_(plane), slack_(slack) {
    add_ring(footprint.polygon.outer);
    for (const auto& hole : footprint.polygon.holes) add_ring(hole);
    for (const auto& [a, b] : edges_) places_.push_back(a.x());
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  }

  std::vector<Aabb> cover(const std::function<bool(const Footprint&)>& held) const {
    std::vector<Aabb> out;
    std::vector<Part> run;  // of parts that follow each other and are not held
    for (const Part& part : parts()) {
      if (held(footprint_of(part, part.high))) {
        add(run, out);
        run.clear();
        continue;
      }
      run.push_back(part);
      if (!keeps_slack(run)) {
        run.pop_back();
        add(run, out);
        run = {part};
      }
    }
    add(run, out);
    return out;
  }

 private:
  // Edges as pairs of (place along the surface, height).
  void add_ring(const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges_.emplace_back(seen(ring[i], first_ + i),
                          seen(ring[(i + 1) % ring.size()], first_ + (i + 1) % ring.size()));
    }
    first_ += ring.size();
  }

  Vec2 seen(const Vec2& p, std::size_t corner) const {
    const double z =
        corner < footprint_.heights.size() ? footprint_.heights[corner] : footprint_.top;
    return {plane_.along.dot(p - plane_.centre), z};
  }

  static double height_at(const Vec2& a, const Vec2& b, double place) {
    if (a.x() == b.x()) return std::max(a.y(), b.y());
    const double t = std::clamp((place - a.x()) / (b.x() - a.x()), 0.0, 1.0);
    return a.y() + t * (b.y() - a.y());
  }

  // The highest edges over each stretch between neighbouring corners, cut where they rise.
  std::vector<Part> parts() const {
    std::vector<Part> out;
    if (places_.size() < 2) {
      out.push_back({places_.front(), places_.front(), plane_.high, plane_.high});
      return out;
    }
    const double rise = overlap_of(slack_) / 2;
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      const double from = places_[i];
      const double to = places_[i + 1];
      const Vec2 top = top_over(from, to);
      if (top.x() == -std::numeric_limits<double>::infinity()) continue;
      const double n = std::clamp(std::ceil(std::abs(top.y() - top.x()) / rise), 1.0, kMostParts);
      for (double k = 0; k < n; ++k) {
        const auto height = [&](double t) { return top.x() + t * (top.y() - top.x()); };
        const auto place = [&](double t) { return t == 1 ? to : from + t * (to - from); };
        const double a = height(k / n);
        const double b = height((k + 1) / n);
        out.push_back({place(k / n), place((k + 1) / n), std::min(a, b), std::max(a, b)});
      }
    }
    return out;
  }

  // At both ends of a stretch that no corner is within: at least the height of all edges there.
  Vec2 top_over(double from, double to) const {
    Vec2 top = Vec2::Constant(-std::numeric_limits<double>::infinity());
    for (const auto& [a, b] : edges_) {
      if (std::min(a.x(), b.x()) > from || std::max(a.x(), b.x()) < to) continue;
      top = top.cwiseMax(Vec2(height_at(a, b, from), height_at(a, b, to)));
    }
    return top;
  }

  Footprint footprint_of(const Part& part, double top) const {
    const auto at = [&](double place, double aside) {
      return Vec2(plane_.centre + plane_.along * place + plane_.across * aside);
    };
    Footprint out;
    out.polygon.outer = {at(part.from, plane_.across_low), at(part.to, plane_.across_low),
                         at(part.to, plane_.across_high), at(part.from, plane_.across_high)};
    out.bottom = footprint_.bottom;
    // Rounding of the height between corners.
    out.top = std::min(plane_.high, top + 1e-9);
    return out;
  }

  static Part joined(const std::vector<Part>& run) {
    Part out = run.front();
    for (const Part& part : run) {
      out.to = part.to;
      out.low = std::min(out.low, part.low);
      out.high = std::max(out.high, part.high);
    }
    return out;
  }

  // How far a point over the part, below its highest, may be from what is below the surface: beside
  // by the thickness; and as far below as the part rises, or along to where it is that high.
  double stray(const Part& part) const {
    return std::hypot(plane_.thickness(), std::min(part.to - part.from, part.high - part.low));
  }

  bool keeps_slack(const std::vector<Part>& run) const {
    return run.size() == 1 ||
           (run[run.size() - 2].to == run.back().from && stray(joined(run)) <= slack_ / 2);
  }

  void add(const std::vector<Part>& run, std::vector<Aabb>& out) const {
    if (run.empty()) return;
    const Part part = joined(run);
    const Footprint piece = footprint_of(part, part.high);
    for (const Rectangle& r : geom::cover(piece.polygon, slack_ - stray(part) - 4e-9)) {
      out.push_back({{r.min.x(), r.min.y(), piece.bottom}, {r.max.x(), r.max.y(), piece.top}});
    }
  }

  const Footprint& footprint_;
  const PlaneFit& plane_;
  double slack_;
  std::size_t first_ = 0;  // corner of the ring that is added next
  std::vector<std::pair<Vec2, Vec2>> edges_;
  std::vector<double> places_;
};

}  // namespace

std::vector<Aabb> cover_upright(const Footprint& footprint, const PlaneFit& plane, double slack,
                                const std::function<bool(const Footprint&)>& held) {
  return UprightCover(footprint, plane, slack).cover(held);
}

}  // namespace geom
