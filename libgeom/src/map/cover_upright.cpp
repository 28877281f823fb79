#include "cover_upright.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cover_slope.h"
#include "geom/shape/cover.h"
#include "held_parts.h"
#include "held_within.h"

namespace geom {
namespace {

constexpr double kMostParts = 1e6;     // of one stretch between two corners
constexpr double kTopRounding = 1e-9;  // metres: of the height between corners

// Some of the surface, from one place along it to another, and the range of its top.
struct Part {
  double from;
  double to;
  double low;
  double high;
};

// Of two that follow each other.
Part joined(const Part& first, const Part& second) {
  return {first.from, second.to, std::min(first.low, second.low),
          std::max(first.high, second.high)};
}

// What lies between two neighbouring corners, cut into parts where its top rises.
struct Stretch {
  double from;
  double to;
  Vec2 top;  // at both ends
  double parts;

  double height(double k) const { return top.x() + k / parts * (top.y() - top.x()); }
  double place(double k) const { return k == parts ? to : from + k / parts * (to - from); }

  // Those from `first` up to `last`, as one.
  Part part(std::size_t first, std::size_t last) const {
    const auto i = static_cast<double>(first);
    const auto j = static_cast<double>(last);
    const double a = height(i);
    const double b = height(j);
    return {place(i), place(j), std::min(a, b), std::max(a, b)};
  }
};

class UprightCover {
 public:
  UprightCover(const Footprint& footprint, const PlaneFit& plane, double slack,
               const BoxRuns& others)
      : footprint_(footprint), plane_(plane), slack_(slack) {
    add_ring(footprint.polygon.outer);
    for (const auto& hole : footprint.polygon.holes) add_ring(hole);
    for (const auto& [a, b] : edges_) places_.push_back(a.x());
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    near_ = others.as_high_as(
        reach_of(footprint_of({places_.front(), places_.back(), plane_.low, plane_.low})));
  }

  std::vector<Aabb> cover() {
    if (places_.size() < 2) {
      cover_stretch({places_.front(), places_.front(), Vec2::Constant(plane_.high), 1});
    }
    const double rise = overlap_of(slack_) / 2;
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      const Vec2 top = top_over(places_[i], places_[i + 1]);
      if (top.x() == -std::numeric_limits<double>::infinity()) continue;
      const double n = std::clamp(std::ceil(std::abs(top.y() - top.x()) / rise), 1.0, kMostParts);
      cover_stretch({places_[i], places_[i + 1], top, n});
    }
    end_run();
    return std::move(boxes_);
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

  // At both ends of a stretch that no corner is within: at least the height of all edges there.
  Vec2 top_over(double from, double to) const {
    Vec2 top = Vec2::Constant(-std::numeric_limits<double>::infinity());
    for (const auto& [a, b] : edges_) {
      if (std::min(a.x(), b.x()) > from || std::max(a.x(), b.x()) < to) continue;
      top = top.cwiseMax(Vec2(height_at(a, b, from), height_at(a, b, to)));
    }
    return top;
  }

  Vec2 at(double place, double aside) const {
    return plane_.centre + plane_.along * place + plane_.across * aside;
  }

  WallStretch in_plan(const Stretch& s) const {
    const auto end = [&](double place, double top) {
      return WallStretch::End{at(place, plane_.across_low), at(place, plane_.across_high), top};
    };
    return {end(s.from, s.top.x()), end(s.to, s.top.y()), footprint_.bottom};
  }

  // What others do not hold becomes runs of parts that follow each other.
  void cover_stretch(const Stretch& stretch) {
    const auto count = static_cast<std::size_t>(stretch.parts);
    const std::vector<Held> held = held_parts(in_plan(stretch), count, kTopRounding, near_);
    for (std::size_t i = 0; i < count;) {
      std::size_t end = i + 1;
      if (held[i] != Held::perhaps) {
        while (end < count && held[end] == held[i]) ++end;
      }
      const bool is_held =
          held[i] == Held::yes ||
          (held[i] == Held::perhaps && is_held_(footprint_of(stretch.part(i, end)), near_));
      is_held ? end_run() : add_to_run(stretch, i, end);
      i = end;
    }
  }

  void add_to_run(const Stretch& stretch, std::size_t first, std::size_t last) {
    while (first < last) {
      const std::size_t fit = fitting(stretch, first, last);
      if (fit == first) {
        end_run();
        run_ = stretch.part(first, first + 1);
        ++first;
      } else {
        run_ = joined(*run_, stretch.part(first, fit));
        first = fit;
      }
    }
  }

  // Up to where parts from `first` on fit into the run: more rise more.
  std::size_t fitting(const Stretch& stretch, std::size_t first, std::size_t last) const {
    if (!run_ || run_->to != stretch.part(first, first + 1).from) return first;
    const auto fits = [&](std::size_t end) {
      return stray(joined(*run_, stretch.part(first, end))) <= slack_ / 2;
    };
    std::size_t good = first;
    std::size_t step = 1;
    while (good < last && fits(std::min(last, good + step))) {
      good = std::min(last, good + step);
      step *= 2;
    }
    for (std::size_t bad = std::min(last, good + step); good + 1 < bad;) {
      const std::size_t middle = good + (bad - good) / 2;
      (fits(middle) ? good : bad) = middle;
    }
    return good;
  }

  // Up to its highest; until the next one is asked for.
  const Footprint& footprint_of(const Part& part) {
    piece_.polygon.outer = {at(part.from, plane_.across_low), at(part.to, plane_.across_low),
                            at(part.to, plane_.across_high), at(part.from, plane_.across_high)};
    piece_.bottom = footprint_.bottom;
    piece_.top = std::min(plane_.high, part.high + kTopRounding);
    return piece_;
  }

  // How far a point over the part, below its highest, may be from what is below the surface: beside
  // by the thickness; and as far below as the part rises, or along to where it is that high.
  double stray(const Part& part) const {
    return std::hypot(plane_.thickness(), std::min(part.to - part.from, part.high - part.low));
  }

  void end_run() {
    if (!run_) return;
    const Footprint& piece = footprint_of(*run_);
    for (const Rectangle& r : geom::cover(piece.polygon, slack_ - stray(*run_) - 4e-9)) {
      boxes_.push_back({{r.min.x(), r.min.y(), piece.bottom}, {r.max.x(), r.max.y(), piece.top}});
    }
    run_.reset();
  }

  const Footprint& footprint_;
  const PlaneFit& plane_;
  double slack_;
  std::size_t first_ = 0;  // corner of the ring that is added next
  std::vector<std::pair<Vec2, Vec2>> edges_;
  std::vector<double> places_;
  std::vector<Aabb> near_;  // of the other boxes
  HeldWithin is_held_;
  std::optional<Part> run_;  // of parts that follow each other and are not held
  Footprint piece_;
  std::vector<Aabb> boxes_;
};

}  // namespace

std::vector<Aabb> cover_upright(const Footprint& footprint, const PlaneFit& plane, double slack,
                                const BoxRuns& others) {
  return UprightCover(footprint, plane, slack, others).cover();
}

}  // namespace geom
