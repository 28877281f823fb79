#include "slack_gauge.h"

#include <cmath>
#include <limits>

namespace geom {
namespace {

constexpr double kSurelyFar = 1.0001;   // a share of the slack
constexpr double kLong = 16;            // times as long as high
constexpr std::size_t kManyEdges = 32;  // near a slab: looking at each beside all is no short cut

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 corner(const Rectangle& r, std::size_t which) {
  return {which % 2 != 0 ? r.max.x() : r.min.x(), which >= 2 ? r.max.y() : r.min.y()};
}

// Across its longer side.
std::pair<Rectangle, Rectangle> halves(const Rectangle& r) {
  const int axis = r.max.x() - r.min.x() >= r.max.y() - r.min.y() ? 0 : 1;
  std::pair<Rectangle, Rectangle> out{r, r};
  out.first.max[axis] = out.second.min[axis] = 0.5 * (r.min[axis] + r.max[axis]);
  return out;
}

}  // namespace

SlackGauge::SlackGauge(double slack, std::size_t rings)
    : slack_(slack),
      near_squared_((kSurelyNear * slack) * (kSurelyNear * slack)),
      far_squared_((kSurelyFar * slack) * (kSurelyFar * slack)),
      reach_(1.01 * slack),
      winding_(rings) {}

void SlackGauge::begin(double y0, double y1) {
  y0_ = y0;
  y1_ = y1;
  near_.clear();
}

Rectangle SlackGauge::around(const CoverEdge& edge) const {
  const Interval x = edge.range(y0_, y1_);
  return {{x.low, y0_}, {x.high, y1_}};
}

std::optional<bool> SlackGauge::clear_case() {
  unclear_.clear();
  if (near_.size() > kManyEdges) {
    unclear_.push_back({Vec2::Constant(-kInfinity), Vec2::Constant(kInfinity)});
    return std::nullopt;
  }
  if (refuses_again()) return false;
  close_ = false;
  for (const CoverEdge* edge : near_) {
    if (!look_at(*edge)) return false;
  }
  if (close_) return std::nullopt;
  for (const Rectangle& r : unclear_) {
    const auto near = clear_case(r);
    if (!near || !*near) return near;
  }
  return true;
}

bool SlackGauge::refuses_again() {
  if (!refusing_ || !meets(*refusing_)) return false;
  const Vec2 p = corner(around(*refusing_), refusing_corner_);
  return !is_near(far_squared_, p) && !is_inside(p);
}

// False where a corner of what the edge bounds is surely too far.
bool SlackGauge::look_at(const CoverEdge& edge) {
  if (!meets(edge)) return true;
  const Rectangle r = around(edge);
  bool beside = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 p = corner(r, i);
    if (edge.is_within(near_squared_, p)) continue;
    beside = false;
    if (is_near(near_squared_, p) || is_inside(p)) continue;
    if (!is_near(far_squared_, p)) {
      refusing_ = &edge;
      refusing_corner_ = i;
      return false;
    }
    close_ = true;
  }
  if (!beside) add_unclear(r, edge);
  return true;
}

// The parts of the rectangle around an edge that are not surely within the slack of it. Between a
// corner and its two neighbours the distance is at most what it is at the three, weighted; so what
// exceeds the slack at the corner alone does so in a smaller rectangle there.
void SlackGauge::add_unclear(const Rectangle& r, const CoverEdge& edge) {
  const double slack = kSurelyNear * slack_;
  std::array<double, 4> distance;
  for (std::size_t i = 0; i < 4; ++i) {
    distance[i] = std::sqrt(edge.squared_distance(corner(r, i)));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double excess = distance[i] - slack;
    if (excess <= 0) continue;
    const double aside = distance[i ^ 1];  // of the neighbours along x and y
    const double along = distance[i ^ 2];
    if (aside > slack || along > slack) {
      unclear_.push_back(r);
      return;
    }
    const Vec2 p = corner(r, i);
    const Vec2 reach =
        (corner(r, i ^ 3) - p)
            .cwiseProduct(Vec2(excess / (distance[i] - aside), excess / (distance[i] - along)));
    unclear_.push_back({p.cwiseMin(p + reach), p.cwiseMax(p + reach)});
  }
}

// The same of one rectangle.
std::optional<bool> SlackGauge::clear_case(const Rectangle& r) {
  if (beside_any(r)) return true;
  const Vec2 centre = 0.5 * (r.min + r.max);
  const bool inside = is_inside(centre);
  if (!inside && !is_near(far_squared_, centre)) return false;
  if (inside && clear_of_edges(r)) return true;
  if (within_bands(r)) return true;
  if ((r.max - r.min).maxCoeff() < 0.1 * slack_) return std::nullopt;
  const auto [first, second] = halves(r);
  const auto near = clear_case(first);
  return near && *near ? clear_case(second) : near;
}

// Whether an edge is that near, which is no further than surely far.
bool SlackGauge::is_near(double squared_reach, const Vec2& p) const {
  for (const CoverEdge* edge : near_) {
    if (!out_of_reach(*edge, p.x()) && edge->is_within(squared_reach, p)) return true;
  }
  return false;
}

// Whether all of the rectangle is surely within the slack of the edge.
bool SlackGauge::beside(const Rectangle& r, const CoverEdge& edge) const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!edge.is_within(near_squared_, corner(r, i))) return false;
  }
  return true;
}

bool SlackGauge::beside_any(const Rectangle& r) const {
  for (const CoverEdge* edge : near_) {
    if (!out_of_reach(*edge, r.min.x()) && !out_of_reach(*edge, r.max.x()) && beside(r, *edge)) {
      return true;
    }
  }
  return false;
}

// Whether a long rectangle, along which an edge runs, is surely allowed as a band beside the edge,
// one above and one below that are inside. Halving it would end only where it is as long as high.
bool SlackGauge::within_bands(const Rectangle& r) {
  const Vec2 size = r.max - r.min;
  if (size.x() < kLong * std::max(size.y(), slack_)) return false;
  const auto settled = [&](double low, double high) {
    const Rectangle band{{r.min.x(), low}, {r.max.x(), high}};
    return low >= high || beside_any(band) ||
           (is_inside(0.5 * (band.min + band.max)) && clear_of_edges(band));
  };
  for (const CoverEdge* edge : near_) {
    if (edge->left > r.min.x() || edge->right < r.max.x()) continue;
    const auto at = [&](double x) {
      const double t = (x - edge->low.x()) / (edge->high.x() - edge->low.x());
      return edge->low.y() + t * (edge->high.y() - edge->low.y());
    };
    const double reach = 0.4 * slack_;
    const double from = std::max(r.min.y(), std::min(at(r.min.x()), at(r.max.x())) - reach);
    const double to = std::min(r.max.y(), std::max(at(r.min.x()), at(r.max.x())) + reach);
    if (from < to && settled(from, to) && settled(r.min.y(), from) && settled(to, r.max.y())) {
      return true;
    }
  }
  return false;
}

// Whether it is no further from one of them than rectangles are rounded outward.
bool SlackGauge::touches_unclear(const Rectangle& r) const {
  const double pad = 2e-3 * slack_;
  for (const Rectangle& u : unclear_) {
    if (u.min.x() <= r.max.x() + pad && r.min.x() <= u.max.x() + pad &&
        u.min.y() <= r.max.y() + pad && r.min.y() <= u.max.y() + pad) {
      return true;
    }
  }
  return false;
}

bool SlackGauge::allows(const Rectangle& r) {
  if (!touches_unclear(r)) return true;
  const double radius = (0.5 * (r.max - r.min)).norm() * (1 + 1e-12);
  const bool few = near_.size() <= kManyEdges;
  // A large one that no edge meets is settled at once, others by their parts.
  if (few && radius > slack_ && clear_of_edges(r)) {
    const Vec2 centre = 0.5 * (r.min + r.max);
    if (is_inside(centre)) return true;
    if (!is_near(far_squared_, centre)) return false;
  }
  if (!few || radius <= slack_) {
    const Vec2 centre = 0.5 * (r.min + r.max);
    const double aside = to_edge(centre, (1 - 1e-9) * (slack_ - radius));
    if (aside + radius <= slack_) return true;
    const bool inside = is_inside(centre);
    if (inside && radius <= slack_) return true;
    if (!inside && aside > slack_) return false;
    if (radius < 0.02 * slack_) return false;
    // A part beside an edge or wholly inside would be halved down to the slack for nothing.
    if (few && beside_any(r)) return true;
    if (inside && clear_of_edges(r)) return true;
  }
  if (few && within_bands(r)) return true;
  const auto [first, second] = halves(r);
  return allows(first) && allows(second);
}

// From p to the nearest edge where that is at most the slack, or less than `enough` as soon as one
// is; else more than the slack.
double SlackGauge::to_edge(const Vec2& p, double enough) const {
  const double squared_enough = enough > 0 ? enough * enough : 0;
  double best = kInfinity;  // squared
  for (const CoverEdge* edge : near_) {
    if (out_of_reach(*edge, p.x())) continue;
    best = std::min(best, edge->squared_distance(p));
    if (best < squared_enough) break;
  }
  return std::sqrt(best);
}

bool SlackGauge::is_inside(const Vec2& p) {
  winding_.clear();
  bool odd = false;
  for (const CoverEdge* edge : near_) {
    if (!edge->is_right_of(p)) continue;
    winding_.count(*edge);
    odd = !odd;
  }
  return odd || winding_.inside();
}

// Whether no edge meets the rectangle, rounded outward.
bool SlackGauge::clear_of_edges(const Rectangle& r) const {
  for (const CoverEdge* edge : near_) {
    if (edge->low.y() > r.max.y() || edge->high.y() < r.min.y()) continue;
    const Interval x = edge->range(r.min.y(), r.max.y());
    if (outward(x.high, 1) >= r.min.x() && outward(x.low, -1) <= r.max.x()) return false;
  }
  return true;
}

}  // namespace geom
