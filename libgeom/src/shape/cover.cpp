#include "geom/shape/cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/base/rounding.h"
#include "orientation.h"

namespace geom {
namespace {

constexpr double kLeastSlack = 1e-6;  // metres

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low;
  double high;
};

// A polygon's edge, from its lower to its upper end.
struct Edge {
  Vec2 low;
  Vec2 high;
  int ring;  // 0 is the outer one
  int turn;  // 1 where the ring runs upward along it, -1 downward

  double x_at(double y) const {
    if (high.y() == low.y()) return low.x();
    const double t = std::clamp((y - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    return low.x() + t * (high.x() - low.x());
  }
};

double outward(double v, double sign) {
  const double pad = 1e-9 + 4 * ulp(v);
  return v + sign * pad;
}

std::vector<Interval> merged(std::vector<Interval> list) {
  std::sort(list.begin(), list.end(), [](const Interval& a, const Interval& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  std::vector<Interval> out;
  for (const Interval& i : list) {
    if (!out.empty() && i.low <= out.back().high) {
      out.back().high = std::max(out.back().high, i.high);
    } else {
      out.push_back(i);
    }
  }
  return out;
}

// The polygon cut by slabs [y0, y1], from the lowest up: what only later slabs meet is not looked
// at.
class Slabs {
 public:
  // With `at_corners` a slab that reaches a corner's level ends at one, else as far as it may.
  Slabs(const Polygon& polygon, double slack, bool at_corners)
      : slack_(slack), at_corners_(at_corners), turns_(polygon.holes.size() + 1) {
    add(polygon.outer, 0);
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
      add(polygon.holes[i], static_cast<int>(i) + 1);
    }
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.low.y() < b.low.y(); });
    for (const Edge& edge : edges_) {
      levels_.push_back(edge.low.y());
      levels_.push_back(edge.high.y());
    }
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  }

  std::vector<Rectangle> cover() {
    std::vector<Rectangle> out;
    for (double y0 = edges_.empty() ? 0 : levels_.front();
         !edges_.empty() && y0 < levels_.back();) {
      const double y1 = furthest(y0);
      for (const Rectangle& r : rectangles(y0, y1)) out.push_back(r);
      y0 = y1;
      pass(y0);
    }
    add_flat_edges(out);
    return out;
  }

 private:
  void add(const std::vector<Vec2>& ring, int index) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      const bool up = a.y() <= b.y();
      edges_.push_back({up ? a : b, up ? b : a, index, up ? 1 : -1});
    }
  }

  // Edges along the slabs bound them and are covered with what they bound; spurs are not.
  void add_flat_edges(std::vector<Rectangle>& out) const {
    for (const Edge& edge : edges_) {
      if (edge.low.y() < edge.high.y()) continue;
      const Interval x = range(edge, edge.low.y(), edge.low.y());
      std::vector<Interval> list;
      for (const Rectangle& r : out) {
        if (r.min.y() <= edge.low.y() && r.max.y() >= edge.low.y()) {
          list.push_back({r.min.x(), r.max.x()});
        }
      }
      list = merged(std::move(list));
      if (std::any_of(list.begin(), list.end(),
                      [&](const Interval& i) { return i.low <= x.low && i.high >= x.high; })) {
        continue;
      }
      out.push_back({{outward(x.low, -1), outward(edge.low.y(), -1)},
                     {outward(x.high, 1), outward(edge.low.y(), 1)}});
    }
  }

  // Forgets the edges that end so far below y0 that no slab from there on asks for them.
  void pass(double y0) {
    while (next_ < edges_.size() && edges_[next_].low.y() <= y0) begun_.push_back(&edges_[next_++]);
    std::erase_if(begun_, [&](const Edge* edge) { return edge->high.y() < y0 - 2 * slack_; });
  }

  // Calls f(edge) for each that meets [y0, y1].
  template <class F>
  void for_each_in(double y0, double y1, const F& f) const {
    for (const Edge* edge : begun_) {
      if (edge->high.y() >= y0 && edge->low.y() <= y1) f(*edge);
    }
    for (std::size_t i = next_; i < edges_.size() && edges_[i].low.y() <= y1; ++i) {
      if (edges_[i].high.y() >= y0) f(edges_[i]);
    }
  }

  // Of what lies inside the open slab, and its closure: the edges' own ranges of x, and the gaps
  // between them that lie inside. An upright line through a gap meets no edge in the slab, so it is
  // inside as a whole or outside as a whole, and its middle tells; edges may cross as they like.
  std::vector<Rectangle> rectangles(double y0, double y1) const {
    const double middle = 0.5 * (y0 + y1);
    std::vector<Interval> list;
    std::vector<std::pair<double, const Edge*>> across;
    for_each_in(y0, y1, [&](const Edge& edge) {
      if (!(edge.high.y() > y0 && edge.low.y() < y1)) return;
      list.push_back(range(edge, y0, y1));
      if (edge.low.y() <= middle && edge.high.y() > middle) {
        across.emplace_back(edge.x_at(middle), &edge);
      }
    });
    std::sort(across.begin(), across.end());
    std::vector<int> turns(turns_);
    for (std::size_t i = 0; i + 1 < across.size(); ++i) {
      turns[static_cast<std::size_t>(across[i].second->ring)] += across[i].second->turn;
      if (i % 2 != 0 && !winds_inside(turns)) continue;
      list.push_back({across[i].first, across[i + 1].first});
    }
    std::vector<Rectangle> out;
    for (const Interval& i : merged(std::move(list))) {
      out.push_back({{outward(i.low, -1), outward(y0, -1)}, {outward(i.high, 1), outward(y1, 1)}});
    }
    return out;
  }

  // By winding numbers: within the outer ring, and in no hole.
  static bool winds_inside(const std::vector<int>& turns) {
    return turns[0] != 0 &&
           std::none_of(turns.begin() + 1, turns.end(), [](int t) { return t != 0; });
  }

  // x of the edge's part inside the slab.
  static Interval range(const Edge& edge, double y0, double y1) {
    if (edge.low.y() == edge.high.y()) {
      return {std::min(edge.low.x(), edge.high.x()), std::max(edge.low.x(), edge.high.x())};
    }
    const double a = edge.x_at(std::max(y0, edge.low.y()));
    const double b = edge.x_at(std::min(y1, edge.high.y()));
    return {std::min(a, b), std::max(a, b)};
  }

  // How far the slab from y0 may reach. Each x of its rectangles is that of a point of the polygon
  // in the slab, so one no higher than the slack is always right; a higher one is looked at.
  double furthest(double y0) const {
    const double top = levels_.back();
    const double sure = std::min(top, y0 + slack_ - 4e-9 - 1e-14 * std::abs(y0));
    double good = sure;
    double bad = kInfinity;
    for (auto y1 = std::upper_bound(levels_.begin(), levels_.end(), sure); y1 != levels_.end();
         ++y1) {
      if (!valid(y0, *y1)) {
        bad = *y1;
        break;
      }
      good = *y1;
    }
    if (good >= top || (at_corners_ && good > sure)) return good;
    bad = std::min(bad, good + 8 * slack_);
    if (valid(y0, bad)) return bad;
    for (int i = 0; i < 6; ++i) {
      const double middle = 0.5 * (good + bad);
      (valid(y0, middle) ? good : bad) = middle;
    }
    return good;
  }

  bool valid(double y0, double y1) const {
    std::vector<const Edge*> near;  // all that a point of the slab may be within the slack of
    for_each_in(y0 - 1.5 * slack_, y1 + 1.5 * slack_,
                [&](const Edge& edge) { near.push_back(&edge); });
    for (const Rectangle& r : rectangles(y0, y1)) {
      if (!within_slack(r, near)) return false;
    }
    return true;
  }

  // The distance to the polygon grows by no more than one goes, so a piece whose centre is near
  // enough for its corners is settled.
  bool within_slack(const Rectangle& r, const std::vector<const Edge*>& near) const {
    const Vec2 half = 0.5 * (r.max - r.min);
    const double at_centre = distance_to(Vec2(0.5 * (r.min + r.max)), near);
    const double radius = half.norm() * (1 + 1e-12);
    if (at_centre + radius <= slack_) return true;
    if (at_centre > slack_ || radius < 0.02 * slack_) return false;
    // A part wholly inside would be halved down to the slack for nothing.
    if (at_centre == 0 && clear_of_edges(r, near)) return true;
    Rectangle first = r;
    Rectangle second = r;
    const int axis = half.x() >= half.y() ? 0 : 1;
    first.max[axis] = second.min[axis] = 0.5 * (r.min[axis] + r.max[axis]);
    return within_slack(first, near) && within_slack(second, near);
  }

  // From p to the polygon where that is at most the slack; else more than it. 0 inside.
  double distance_to(const Vec2& p, const std::vector<const Edge*>& near) const {
    std::vector<int> turns(turns_);
    bool odd = false;
    double best = kInfinity;
    for (const Edge* edge : near) {
      const Vec2 d = edge->high - edge->low;
      const double square = d.squaredNorm();
      const double t = square > 0 ? std::clamp((p - edge->low).dot(d) / square, 0.0, 1.0) : 0;
      best = std::min(best, (edge->low + t * d - p).norm());
      if (edge->low.y() > p.y() || edge->high.y() <= p.y() ||
          orientation(edge->low.x(), edge->low.y(), edge->high.x(), edge->high.y(), p.x(), p.y()) <=
              0) {
        continue;
      }
      turns[static_cast<std::size_t>(edge->ring)] += edge->turn;
      odd = !odd;
    }
    return odd || winds_inside(turns) ? 0 : best;
  }

  // Whether no edge meets the rectangle.
  static bool clear_of_edges(const Rectangle& r, const std::vector<const Edge*>& near) {
    return std::none_of(near.begin(), near.end(), [&](const Edge* edge) {
      if (edge->low.y() > r.max.y() || edge->high.y() < r.min.y()) return false;
      const Interval x = range(*edge, r.min.y(), r.max.y());
      return outward(x.high, 1) >= r.min.x() && outward(x.low, -1) <= r.max.x();
    });
  }

  double slack_;
  bool at_corners_;
  std::vector<int> turns_;          // a zero for each ring
  std::vector<Edge> edges_;         // by their lower end
  std::size_t next_ = 0;            // the first edge that begins above the slab's lower end
  std::vector<const Edge*> begun_;  // those before it that are still near
  std::vector<double> levels_;      // the y of all corners, ascending
};

Polygon transposed(const Polygon& polygon) {
  const auto swap = [](std::vector<Vec2> ring) {
    for (Vec2& p : ring) std::swap(p.x(), p.y());
    return ring;
  };
  Polygon out{swap(polygon.outer), {}};
  for (const auto& hole : polygon.holes) out.holes.push_back(swap(hole));
  return out;
}

void require(const Polygon& polygon, double slack) {
  double largest = 0;
  const auto look_at = [&](const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) {
      require_point("polygon", {p.x(), p.y(), 0});
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  };
  look_at(polygon.outer);
  for (const auto& hole : polygon.holes) look_at(hole);
  const double least = std::max(kLeastSlack, 0.999 * 1e-9 * largest);  // a product may be rounded
  if (slack >= least && slack <= kLargestCoordinate) return;
  throw InputError("slack", fmt::format("expected metres from {} to {}, found {}", least,
                                        kLargestCoordinate, slack));
}

}  // namespace

std::vector<Rectangle> cover(const Polygon& polygon, double slack) {
  require(polygon, slack);
  std::vector<Rectangle> best = Slabs(polygon, slack, true).cover();
  const auto consider = [&](std::vector<Rectangle> other) {
    if (other.size() < best.size()) best = std::move(other);
  };
  if (best.size() <= 1) return best;
  consider(Slabs(polygon, slack, false).cover());
  const Polygon turned = transposed(polygon);
  for (const bool at_corners : {true, false}) {
    std::vector<Rectangle> across = Slabs(turned, slack, at_corners).cover();
    for (Rectangle& r : across) {
      std::swap(r.min.x(), r.min.y());
      std::swap(r.max.x(), r.max.y());
    }
    consider(std::move(across));
  }
  return best;
}

}  // namespace geom
