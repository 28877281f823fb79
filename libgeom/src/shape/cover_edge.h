#pragma once

// The edges of a polygon that is covered, and on which side of them a point is.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geom/base/rounding.h"
#include "geom/shape/cover.h"
#include "orientation.h"

namespace geom {

struct Interval {
  double low;
  double high;
};

// A side of a rectangle, rounded to where the sign points.
inline double outward(double v, double sign) {
  const double pad = 1e-9 + 4 * ulp(v);
  return v + sign * pad;
}

// An edge, from its lower to its upper end.
struct CoverEdge {
  Vec2 low;
  Vec2 high;
  int ring;  // 0 is the outer one
  int turn;  // 1 where the ring runs upward along it, -1 downward
  Vec2 step = high - low;
  double squared = step.squaredNorm();
  double left = std::min(low.x(), high.x());
  double right = std::max(low.x(), high.x());
  // Its length over its run, which is how high a slab may be for each metre of slack.
  double length_over_run = std::sqrt(squared) / std::abs(step.x());
  double run_over_length = 1 / length_over_run;

  double x_at(double y) const {
    if (high.y() == low.y()) return low.x();
    const double t = std::clamp((y - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    return low.x() + t * (high.x() - low.x());
  }

  // x of its part with y in [y0, y1], which it meets.
  Interval range(double y0, double y1) const {
    if (low.y() == high.y()) return {left, right};
    const double a = y0 <= low.y() ? low.x() : x_at(y0);
    const double b = x_at(std::min(y1, high.y()));
    return {std::min(a, b), std::max(a, b)};
  }

  double squared_distance(const Vec2& p) const {
    const double t = squared > 0 ? std::clamp((p - low).dot(step) / squared, 0.0, 1.0) : 0;
    return (low + t * step - p).squaredNorm();
  }

  // Whether the point is that near, to rounding. Quicker than the distance: no division.
  bool is_within(double squared_reach, const Vec2& p) const {
    const Vec2 to = p - low;
    const double along = to.dot(step);
    if (along <= 0) return to.squaredNorm() <= squared_reach;
    if (along >= squared) return (p - high).squaredNorm() <= squared_reach;
    const double across = step.x() * to.y() - step.y() * to.x();
    return across * across <= squared_reach * squared;
  }

  // Whether a level line from the point to the right crosses it; exact. What it ends at below
  // counts, above does not.
  bool is_right_of(const Vec2& p) const {
    if (low.y() > p.y() || high.y() <= p.y()) return false;
    if (p.x() < left) return true;
    if (p.x() > right) return false;
    return orientation(low.x(), low.y(), high.x(), high.y(), p.x(), p.y()) > 0;
  }
};

// Adds the edges of a ring. Number 0 is the outer one.
inline void add_edges(const std::vector<Vec2>& ring, int number, std::vector<CoverEdge>& to) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool up = a.y() <= b.y();
    to.push_back({up ? a : b, up ? b : a, number, up ? 1 : -1});
  }
}

// How often each ring turns around a point: the edges to one side of it, counted.
class Winding {
 public:
  explicit Winding(std::size_t rings) : hole_turns_(rings - 1) {}

  void clear() {
    if (counted_) std::fill(hole_turns_.begin(), hole_turns_.end(), 0);
    turns_ = 0;
    holes_ = 0;
    counted_ = false;
  }

  void count(const CoverEdge& edge) { turn(edge, edge.turn); }
  void take_back(const CoverEdge& edge) { turn(edge, -edge.turn); }  // one that was counted

  // Within the outer ring, and in no hole.
  bool inside() const { return turns_ != 0 && holes_ == 0; }

 private:
  void turn(const CoverEdge& edge, int by) {
    counted_ = true;
    if (edge.ring == 0) {
      turns_ += by;
      return;
    }
    int& turns = hole_turns_[static_cast<std::size_t>(edge.ring) - 1];
    const bool around = turns != 0;
    turns += by;
    if (around != (turns != 0)) around ? --holes_ : ++holes_;
  }

  int turns_ = 0;  // of the outer ring
  std::vector<int> hole_turns_;
  int holes_ = 0;  // that turn around it
  bool counted_ = false;
};

}  // namespace geom
