#include "slack_gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geom {
namespace {

constexpr double kSurelyFar = 1.0001;  // a share of the slack
constexpr double kLong = 16;           // times as long as high
constexpr double kTouching = 2e-3;     // of the slack: more than rectangles are rounded outward
constexpr double kLeaf = 0.02;         // of the slack: the radius of what is not halved any more
constexpr double kMuch = 4;            // times as long as what is unclear of it
constexpr std::size_t kFewParts = 4;
constexpr std::size_t kManyEdges = 64;  // near a slab: looking at each beside all is no short cut

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 corner(const Rectangle& r, std::size_t which) {
  return {which % 2 != 0 ? r.max.x() : r.min.x(), which >= 2 ? r.max.y() : r.min.y()};
}

// From the middle of a rectangle of this size to its corners, rounded up.
double radius_of(const Vec2& size) { return (0.5 * size).norm() * (1 + 1e-12); }

// Across its longer side.
std::pair<Rectangle, Rectangle> halves(const Rectangle& r) {
  const int axis = r.max.x() - r.min.x() >= r.max.y() - r.min.y() ? 0 : 1;
  std::pair<Rectangle, Rectangle> out{r, r};
  out.first.max[axis] = out.second.min[axis] = 0.5 * (r.min[axis] + r.max[axis]);
  return out;
}

bool holds(const Rectangle& r, const Vec2& p) {
  return p.x() >= r.min.x() && p.x() <= r.max.x() && p.y() >= r.min.y() && p.y() <= r.max.y();
}

// Whether the edge meets the rectangle, rounded outward.
bool may_meet(const CoverEdge& edge, const Rectangle& r) {
  if (edge.low.y() > r.max.y() || edge.high.y() < r.min.y()) return false;
  if (edge.left > r.max.x() + 1e-6 || edge.right < r.min.x() - 1e-6) return false;
  const Interval x = edge.range(r.min.y(), r.max.y());
  return outward(x.high, 1) >= r.min.x() && outward(x.low, -1) <= r.max.x();
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Whether two edges surely come no nearer to each other than the reach.
bool are_apart(const CoverEdge& a, const CoverEdge& b, double reach) {
  if (a.left > b.right + reach || b.left > a.right + reach || a.low.y() > b.high.y() + reach ||
      b.low.y() > a.high.y() + reach) {
    return true;
  }
  const double squared = reach * reach;
  if (a.is_within(squared, b.low) || a.is_within(squared, b.high) || b.is_within(squared, a.low) ||
      b.is_within(squared, a.high)) {
    return false;
  }
  const bool both_sides_of_a = cross(a.step, b.low - a.low) * cross(a.step, b.high - a.low) <= 0;
  const bool both_sides_of_b = cross(b.step, a.low - b.low) * cross(b.step, a.high - b.low) <= 0;
  return !(both_sides_of_a && both_sides_of_b);
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
    unclear_size_ = kInfinity;
    unclear_.push_back({{Vec2::Constant(-kInfinity), Vec2::Constant(kInfinity)}});
    return std::nullopt;
  }
  if (refuses_again()) return false;
  for (const CoverEdge* edge : near_) {
    if (!look_at(*edge)) return false;
  }
  // What stays unclear is what allows() looks at.
  std::swap(unclear_, found_);
  unclear_.clear();
  unclear_size_ = 0;
  for (const Unclear& unclear : found_) {
    if (unclear.close) {
      keep_unclear(unclear);
      continue;
    }
    const std::size_t before = unclear_.size();
    if (!settle(unclear.place)) return false;
    if (unclear_.size() <= before + kFewParts) continue;
    unclear_.resize(before);  // halving all of it once is less than asking about each part
    keep_unclear({unclear.place});
  }
  if (!unclear_.empty()) return std::nullopt;
  return true;
}

void SlackGauge::keep_unclear(const Unclear& unclear) {
  const Vec2 size = unclear.place.max - unclear.place.min;
  unclear_size_ = std::max(unclear_size_, size.maxCoeff());
  unclear_.push_back(unclear);
}

bool SlackGauge::refuses_again() {
  if (!refusing_ || !meets(*refusing_)) return false;
  const Vec2 p = corner(around(*refusing_), refusing_corner_);
  return !is_near(far_squared_, p) && !is_inside(p);
}

// The corner moves along its edge. What it passes far from every edge is outside as it is.
bool SlackGauge::refuses_further(double rise) {
  if (!refusing_ || refusing_->low.y() > y0_ || !(refusing_->high.y() >= y1_ + rise)) return false;
  const Vec2 from = corner(around(*refusing_), refusing_corner_);
  const Vec2 to = from + refusing_->step * (rise / refusing_->step.y());
  if (is_inside(from)) return false;
  const CoverEdge way{from, to, 0, 1};
  return std::all_of(near_.begin(), near_.end(),
                     [&](const CoverEdge* edge) { return are_apart(way, *edge, reach_); });
}

// False where a corner of what the edge bounds is surely too far.
bool SlackGauge::look_at(const CoverEdge& edge) {
  if (!meets(edge)) return true;
  const Rectangle r = around(edge);
  bool beside = true;
  unsigned close = 0;  // a bit for each corner
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
    close |= 1U << i;
  }
  if (!beside) add_unclear(r, edge, close);
  return true;
}

// The parts of the rectangle around an edge that are not surely within the slack of it. Between a
// corner and its two neighbours the distance is at most what it is at the three, weighted; so what
// exceeds the slack at the corner alone does so in a smaller rectangle there.
void SlackGauge::add_unclear(const Rectangle& r, const CoverEdge& edge, unsigned close) {
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
      unclear_.push_back({r, nullptr, 0, close != 0});
      return;
    }
    const Vec2 p = corner(r, i);
    const Vec2 reach =
        (corner(r, i ^ 3) - p)
            .cwiseProduct(Vec2(excess / (distance[i] - aside), excess / (distance[i] - along)));
    unclear_.push_back(
        {{p.cwiseMin(p + reach), p.cwiseMax(p + reach)}, &edge, i, (close >> i & 1) != 0});
  }
}

// False where a point of the rectangle is surely too far; keeps what stays unclear of it. Mostly
// the distance of its middle tells: no point of it is further from the middle than its radius.
bool SlackGauge::settle(const Rectangle& r) {
  const Vec2 size = r.max - r.min;
  const double radius = radius_of(size);
  const double near = kSurelyNear * slack_;
  const Vec2 centre = 0.5 * (r.min + r.max);
  const double aside = to_edge(centre, near - radius);
  if (aside + radius <= near) return true;
  const bool inside = is_inside(centre);
  if (inside && radius <= near) return true;
  if (!inside && aside > kSurelyFar * slack_) return false;
  if (beside_any(r) || within_halves(r, inside) || within_bands(r)) return true;
  if (size.maxCoeff() < 0.1 * slack_) {
    keep_unclear({r});
    return true;
  }
  const auto [first, second] = halves(r);
  return settle(first) && settle(second);
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

// Whether no edge meets the rectangle, whose middle is inside, or one alone, which cuts it into
// halves: those outside are surely near the edge if their corners are, since they are convex.
bool SlackGauge::within_halves(const Rectangle& r, bool middle_inside) {
  const CoverEdge* cut = nullptr;
  for (const CoverEdge* edge : near_) {
    if (!may_meet(*edge, r)) continue;
    if (cut) return false;
    cut = edge;
  }
  if (!cut) return middle_inside;
  if (holds(r, cut->low) || holds(r, cut->high)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 p = corner(r, i);
    if (!cut->is_within(near_squared_, p) && !is_inside(p)) return false;
  }
  return true;
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
  const double pad = kTouching * slack_;
  for (const Unclear& unclear : unclear_) {
    const Rectangle& u = unclear.place;
    if (u.min.x() <= r.max.x() + pad && r.min.x() <= u.max.x() + pad &&
        u.min.y() <= r.max.y() + pad && r.min.y() <= u.max.y() + pad) {
      return true;
    }
  }
  return false;
}

bool SlackGauge::allows(const Rectangle& r) {
  settle_corners(r);
  return allows_parts(r);
}

// Forgets the unclear places at corners of the rectangle that its smallest parts there settle.
void SlackGauge::settle_corners(const Rectangle& r) {
  std::erase_if(unclear_,
                [&](const Unclear& unclear) { return unclear.edge && is_settled(unclear, r); });
}

// Whether allows_parts() surely finds all parts of the rectangle that touch the place near enough
// to its edge, by what it asks of the smallest: the middle within the slack, less the part's
// radius. Their middles lie in the rectangle between that of the part at the corner and a point
// behind the place, and to be near an edge is convex.
bool SlackGauge::is_settled(const Unclear& unclear, const Rectangle& r) const {
  const Vec2 p = corner(around(*unclear.edge), unclear.corner);
  const Vec2 rounded = corner(r, unclear.corner);
  if ((rounded - p).cwiseAbs().maxCoeff() > 0.1 * kTouching * slack_) return false;
  Rectangle part = r;
  double radius = kInfinity;
  const double surely_more = 4.001 * kLeaf * kLeaf * slack_ * slack_;
  while (true) {
    const Vec2 size = part.max - part.min;
    if (size.squaredNorm() < surely_more) {
      radius = radius_of(size);
      if (radius < kLeaf * slack_) break;
    }
    const int axis = size.x() >= size.y() ? 0 : 1;
    const double middle = 0.5 * (part.min[axis] + part.max[axis]);
    const bool upper = (unclear.corner >> axis & 1) != 0;
    (upper ? part.min : part.max)[axis] = middle;
  }
  const Vec2 near = 0.5 * (part.min + part.max);
  const Vec2 opposite = corner(unclear.place, unclear.corner ^ 3);
  const Vec2 inward(unclear.corner % 2 != 0 ? -1 : 1, unclear.corner >= 2 ? -1 : 1);
  const Vec2 behind = opposite + inward * (2 * kLeaf + kTouching) * slack_;
  const Rectangle middles{near.cwiseMin(behind), near.cwiseMax(behind)};
  const double reach = (1 - 1e-9) * (slack_ - radius);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!unclear.edge->is_within(reach * reach, corner(middles, i))) return false;
  }
  return true;
}

// What touches little that is unclear is halved down to that without a look at all edges: what they
// would tell at once, its parts tell too.
bool SlackGauge::allows_parts(const Rectangle& r) {
  if (!touches_unclear(r)) return true;
  const Vec2 size = r.max - r.min;
  const double radius = radius_of(size);
  const bool few = near_.size() <= kManyEdges;
  const bool much = few && size.maxCoeff() < kMuch * unclear_size_;
  // A large one that no edge meets is settled at once, others by their parts.
  if (much && radius > slack_ && clear_of_edges(r)) {
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
    if (radius < kLeaf * slack_) return false;
    // A part beside an edge or wholly inside would be halved down to the slack for nothing.
    if (much && beside_any(r)) return true;
    if (inside && clear_of_edges(r)) return true;
  }
  if (much && within_bands(r)) return true;
  const auto [first, second] = halves(r);
  return allows_parts(first) && allows_parts(second);
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

bool SlackGauge::clear_of_edges(const Rectangle& r) const {
  return std::none_of(near_.begin(), near_.end(),
                      [&](const CoverEdge* edge) { return may_meet(*edge, r); });
}

}  // namespace geom
