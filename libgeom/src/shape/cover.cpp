#include "geom/shape/cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/base/rounding.h"
#include "orientation.h"

namespace geom {
namespace {

constexpr double kLeastSlack = 1e-6;  // metres
// Shares of the slack: what is nearer than the one or further than the other is no close decision,
// however it is rounded.
constexpr double kSurelyNear = 0.978;
constexpr double kSurelyFar = 1.0001;
constexpr std::size_t kManyEdges = 32;  // near a slab: looking at each beside all is no short cut

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
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
  Vec2 step = high - low;
  double squared = step.squaredNorm();

  double x_at(double y) const {
    if (high.y() == low.y()) return low.x();
    const double t = std::clamp((y - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    return low.x() + t * (high.x() - low.x());
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

  // Ends early, with `most` or more rectangles, where there are not fewer.
  std::vector<Rectangle> cover(std::size_t most) {
    std::vector<Rectangle> out;
    for (double y0 = edges_.empty() ? 0 : levels_.front();
         !edges_.empty() && y0 < levels_.back();) {
      const double y1 = furthest(y0);
      for (const Rectangle& r : rectangles(y0, y1)) out.push_back(r);
      if (out.size() >= most) return out;
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
  std::vector<Rectangle> rectangles(double y0, double y1) {
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
    std::fill(turns_.begin(), turns_.end(), 0);
    for (std::size_t i = 0; i + 1 < across.size(); ++i) {
      turns_[static_cast<std::size_t>(across[i].second->ring)] += across[i].second->turn;
      if (i % 2 != 0 && !winds_inside(turns_)) continue;
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
  double furthest(double y0) {
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

  // Whether the slab's rectangles stay within the slack.
  bool valid(double y0, double y1) {
    near_.clear();
    for_each_in(y0 - 1.5 * slack_, y1 + 1.5 * slack_,
                [&](const Edge& edge) { near_.push_back(&edge); });
    if (const auto clear = clear_case(y0, y1)) return *clear;
    for (const Rectangle& r : rectangles(y0, y1)) {
      if (!within_slack(r)) return false;
    }
    return true;
  }

  // What within_slack() would say of all rectangles of the slab, where that is no close decision.
  // Their points are within the ranges of edges, or inside.
  std::optional<bool> clear_case(double y0, double y1) {
    unclear_.clear();
    if (near_.size() > kManyEdges) {
      unclear_.push_back({Vec2::Constant(-kInfinity), Vec2::Constant(kInfinity)});
      return std::nullopt;
    }
    bool close = false;
    const auto look_at = [&](const Edge& edge) {
      if (!(edge.high.y() > y0 && edge.low.y() < y1)) return true;
      const Interval x = range(edge, y0, y1);
      const Rectangle r{{x.low, y0}, {x.high, y1}};
      if (beside(r, edge)) return true;
      for (const Vec2& p : corners(r)) {
        if (is_near(near_squared_, p) || is_inside(p)) continue;
        if (!is_near(far_squared_, p)) return false;
        close = true;
      }
      unclear_.push_back(r);
      return true;
    };
    // The edge that refused the last slab refuses the next most often.
    if (refusing_ && !look_at(*refusing_)) return false;
    for (const Edge* edge : near_) {
      if (edge == refusing_ || look_at(*edge)) continue;
      refusing_ = edge;
      return false;
    }
    if (close) return std::nullopt;
    for (const Rectangle& r : unclear_) {
      const auto near = clear_case(r);
      if (!near || !*near) return near;
    }
    return true;
  }

  // The same of one rectangle.
  std::optional<bool> clear_case(const Rectangle& r) {
    for (const Edge* edge : near_) {
      if (beside(r, *edge)) return true;
    }
    const Vec2 centre = 0.5 * (r.min + r.max);
    const bool inside = is_inside(centre);
    if (!inside && !is_near(far_squared_, centre)) return false;
    if (inside && clear_of_edges(r)) return true;
    if ((r.max - r.min).maxCoeff() < 0.1 * slack_) return std::nullopt;
    const auto [first, second] = halves(r);
    const auto near = clear_case(first);
    return near && *near ? clear_case(second) : near;
  }

  // Whether all of the rectangle is surely within the slack of the edge. The distance to an edge is
  // convex, so it is largest at a corner.
  bool beside(const Rectangle& r, const Edge& edge) const {
    const std::array<Vec2, 4> all = corners(r);
    return std::all_of(all.begin(), all.end(),
                       [&](const Vec2& p) { return edge.is_within(near_squared_, p); });
  }

  // Whether an edge is that near.
  bool is_near(double squared_reach, const Vec2& p) const {
    return std::any_of(near_.begin(), near_.end(),
                       [&](const Edge* edge) { return edge->is_within(squared_reach, p); });
  }

  // Whether they are no further apart than rectangles are rounded outward.
  bool touch(const Rectangle& a, const Rectangle& b) const {
    const double pad = 2e-3 * slack_;
    return (a.min.array() <= b.max.array() + pad).all() &&
           (b.min.array() <= a.max.array() + pad).all();
  }

  static std::array<Vec2, 4> corners(const Rectangle& r) {
    return {r.min, r.max, Vec2(r.min.x(), r.max.y()), Vec2(r.max.x(), r.min.y())};
  }

  // Across its longer side.
  static std::pair<Rectangle, Rectangle> halves(const Rectangle& r) {
    const int axis = r.max.x() - r.min.x() >= r.max.y() - r.min.y() ? 0 : 1;
    std::pair<Rectangle, Rectangle> out{r, r};
    out.first.max[axis] = out.second.min[axis] = 0.5 * (r.min[axis] + r.max[axis]);
    return out;
  }

  // The distance to the polygon grows by no more than one goes, so a piece whose centre is near
  // enough for its corners is settled.
  bool within_slack(const Rectangle& r) {
    if (std::none_of(unclear_.begin(), unclear_.end(),
                     [&](const Rectangle& u) { return touch(u, r); })) {
      return true;
    }
    const Vec2 half = 0.5 * (r.max - r.min);
    const Vec2 centre = 0.5 * (r.min + r.max);
    const double radius = half.norm() * (1 + 1e-12);
    const double aside = to_edge(centre);
    if (aside + radius <= slack_) return true;
    const bool inside = is_inside(centre);
    if (inside && radius <= slack_) return true;
    if (!inside && aside > slack_) return false;
    if (radius < 0.02 * slack_) return false;
    // A part beside an edge or wholly inside would be halved down to the slack for nothing.
    if (near_.size() <= kManyEdges &&
        std::any_of(near_.begin(), near_.end(), [&](const Edge* e) { return beside(r, *e); })) {
      return true;
    }
    if (inside && clear_of_edges(r)) return true;
    const auto [first, second] = halves(r);
    return within_slack(first) && within_slack(second);
  }

  // From p to the nearest edge where that is at most the slack; else more than it.
  double to_edge(const Vec2& p) const {
    double best = kInfinity;  // squared
    for (const Edge* edge : near_) best = std::min(best, edge->squared_distance(p));
    return std::sqrt(best);
  }

  bool is_inside(const Vec2& p) {
    std::fill(turns_.begin(), turns_.end(), 0);
    bool odd = false;
    for (const Edge* edge : near_) {
      if (edge->low.y() > p.y() || edge->high.y() <= p.y() ||
          orientation(edge->low.x(), edge->low.y(), edge->high.x(), edge->high.y(), p.x(), p.y()) <=
              0) {
        continue;
      }
      turns_[static_cast<std::size_t>(edge->ring)] += edge->turn;
      odd = !odd;
    }
    return odd || winds_inside(turns_);
  }

  // Whether no edge meets the rectangle.
  bool clear_of_edges(const Rectangle& r) const {
    return std::none_of(near_.begin(), near_.end(), [&](const Edge* edge) {
      if (edge->low.y() > r.max.y() || edge->high.y() < r.min.y()) return false;
      const Interval x = range(*edge, r.min.y(), r.max.y());
      return outward(x.high, 1) >= r.min.x() && outward(x.low, -1) <= r.max.x();
    });
  }

  double slack_;
  double near_squared_ = (kSurelyNear * slack_) * (kSurelyNear * slack_);
  double far_squared_ = (kSurelyFar * slack_) * (kSurelyFar * slack_);
  bool at_corners_;
  std::vector<Rectangle> unclear_;
  const Edge* refusing_ = nullptr;
  std::vector<int> turns_;          // of each ring around the point that is asked about
  std::vector<const Edge*> near_;   // all that a point of a slab may be within the slack of
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
  std::vector<Rectangle> best = Slabs(polygon, slack, true).cover(kAny);
  const auto consider = [&](std::vector<Rectangle> other) {
    if (other.size() < best.size()) best = std::move(other);
  };
  if (best.size() <= 1) return best;
  consider(Slabs(polygon, slack, false).cover(best.size()));
  const Polygon turned = transposed(polygon);
  for (const bool at_corners : {true, false}) {
    std::vector<Rectangle> across = Slabs(turned, slack, at_corners).cover(best.size());
    for (Rectangle& r : across) {
      std::swap(r.min.x(), r.min.y());
      std::swap(r.max.x(), r.max.y());
    }
    consider(std::move(across));
  }
  return best;
}

}  // namespace geom
