#include "slack_gauge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace geom {
namespace {

constexpr double kLong = 16;        // times as long as high
constexpr double kTouching = 2e-3;  // of the slack: more than rectangles are rounded outward
constexpr double kLeaf = 0.02;      // of the slack: the radius of what is not halved any more
constexpr double kRounded = 1e-5;   // of distances: more than they are rounded by
constexpr double kMuch = 4;         // times as long as what is unclear of it
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
      near_(surely_near(slack)),
      near_squared_(near_ * near_),
      reach_(1.01 * slack),
      touching_(kTouching * slack),
      winding_(rings),
      place_(rings),
      corner_(rings) {}

void SlackGauge::begin(double y0, std::span<const CoverEdge* const> begun) {
  y0_ = y0;
  edges_.clear();
  const auto ends_below = [&](const CoverEdge* edge) { return edge->high.y() < y0 - touching_; };
  std::copy_if(begun.begin(), begun.end(), std::back_inserter(edges_), ends_below);
  first_meeting_ = edges_.size();
  std::remove_copy_if(begun.begin(), begun.end(), std::back_inserter(edges_), ends_below);
  reach_to(y0);
}

void SlackGauge::reach_to(double y1) {
  y1_ = y1;
  end_meeting_ = edges_.size();
  while (end_meeting_ > first_meeting_ && edges_[end_meeting_ - 1]->low.y() > y1 + touching_) {
    --end_meeting_;
  }
}

Rectangle SlackGauge::around(const CoverEdge& edge, double y1) const {
  const Interval x = edge.range(y0_, y1);
  return {{x.low, y0_}, {x.high, y1}};
}

Vec2 SlackGauge::refusing_corner(double y1) const {
  return corner(around(*refusal_.edge, y1), refusal_.corner);
}

std::optional<bool> SlackGauge::clear_case() {
  unclear_.clear();
  found_.clear();
  if (edges_.size() > kManyEdges) {
    unclear_size_ = kInfinity;
    unclear_.push_back({Vec2::Constant(-kInfinity), Vec2::Constant(kInfinity)});
    return std::nullopt;
  }
  if (refuses_again()) return false;
  for (const CoverEdge* edge : meeting()) {
    if (!look_at(*edge)) return false;
  }
  // What stays unclear is what allows() looks at.
  unclear_size_ = 0;
  for (const Rectangle& place : found_) {
    const std::size_t before = unclear_.size();
    if (!settle(place)) return false;
    if (unclear_.size() <= before + kFewParts) continue;
    unclear_.resize(before);  // halving all of it once is less than asking about each part
    keep_unclear(place);
  }
  if (!unclear_.empty()) return std::nullopt;
  return true;
}

void SlackGauge::keep_unclear(const Rectangle& place) {
  unclear_size_ = std::max(unclear_size_, (place.max - place.min).maxCoeff());
  unclear_.push_back(place);
}

bool SlackGauge::refuses_again() {
  if (!refusal_.edge || !meets(*refusal_.edge)) return false;
  const Vec2 p = refusing_corner(y1_);
  return !is_near(near_squared_, p) && !is_inside(p);
}

// The corner moves along its edge, or level with its end.
void SlackGauge::follow_corner(double least) {
  if (!refusal_.edge) return;
  const Vec2 a = refusing_corner(least);
  const Vec2 b = refusing_corner(y1_);
  corner_.gather(edges_, meeting(), {a.cwiseMin(b), a.cwiseMax(b)}, reach_);
}

bool SlackGauge::corner_refuses(double y1) {
  if (!refusal_.edge || !meets_up_to(*refusal_.edge, y1)) return false;
  const Vec2 p = refusing_corner(y1);
  return !corner_.is_near(near_squared_, p) && !corner_.is_inside(p);
}

// The corner moves along its edge. What it passes far from every edge is outside as it is.
bool SlackGauge::refuses_further(double rise) {
  if (!refusal_.edge || refusal_.edge->low.y() > y0_ || !(refusal_.edge->high.y() >= y1_ + rise))
    return false;
  const Vec2 from = refusing_corner(y1_);
  const Vec2 to = from + refusal_.edge->step * (rise / refusal_.edge->step.y());
  if (is_inside(from)) return false;
  const CoverEdge way{from, to, 0, 1};
  return std::all_of(edges_.begin(), edges_.end(),
                     [&](const CoverEdge* edge) { return are_apart(way, *edge, reach_); });
}

// Whether all of what the edge bounds is surely within the slack of it. Between its ends, the edge
// is the diagonal of a rectangle whose other corners are height times run over length from it.
// Points below and above its ends are further by no more than the slab reaches there.
bool SlackGauge::is_steep(const CoverEdge& edge) const {
  const double below = std::max(edge.low.y() - y0_, 0.0);
  const double above = std::max(y1_ - edge.high.y(), 0.0);
  const double height = y1_ - y0_ - below - above;
  return height * edge.run_over_length + std::max(below, above) < (1 - kRounded) * near_;
}

// False where a corner of what the edge bounds is surely too far.
bool SlackGauge::look_at(const CoverEdge& edge) {
  if (!meets(edge) || is_steep(edge)) return true;
  const Rectangle r = around(edge, y1_);
  bool beside = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 p = corner(r, i);
    if (edge.is_within(near_squared_, p)) continue;
    beside = false;
    if (is_inside(p) || is_near(near_squared_, p)) continue;
    refusal_ = {&edge, i};
    return false;
  }
  if (!beside) add_unclear(r, edge);
  return true;
}

// The parts of the rectangle around an edge that are not surely within the slack of it. Between a
// corner and its two neighbours the distance is at most what it is at the three, weighted; so what
// exceeds the slack at the corner alone does so in a smaller rectangle there.
void SlackGauge::add_unclear(const Rectangle& r, const CoverEdge& edge) {
  std::array<double, 4> distance;
  for (std::size_t i = 0; i < 4; ++i) {
    distance[i] = std::sqrt(edge.squared_distance(corner(r, i)));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double excess = distance[i] - near_;
    if (excess <= 0) continue;
    const double aside = distance[i ^ 1];  // of the neighbours along x and y
    const double along = distance[i ^ 2];
    if (aside > near_ || along > near_) {
      found_.push_back(r);
      return;
    }
    const Vec2 p = corner(r, i);
    const Vec2 reach =
        (corner(r, i ^ 3) - p)
            .cwiseProduct(Vec2(excess / (distance[i] - aside), excess / (distance[i] - along)));
    found_.push_back({p.cwiseMin(p + reach), p.cwiseMax(p + reach)});
  }
}

// False where a point of the place is surely too far; keeps what stays unclear of it.
bool SlackGauge::settle(const Rectangle& place) {
  gather(place);
  return settle_part(place);
}

// Mostly the distance of its middle tells: no point of it is further from the middle than its
// radius.
bool SlackGauge::settle_part(const Rectangle& r) {
  const Vec2 size = r.max - r.min;
  const double radius = radius_of(size);
  const Vec2 centre = 0.5 * (r.min + r.max);
  const bool inside = place_.is_inside(centre);
  if (inside && radius <= near_) return true;
  if (radius < near_ && place_.is_near((near_ - radius) * (near_ - radius), centre)) return true;
  if (!inside && !place_.is_near(near_squared_, centre)) return false;
  if (within_halves(r, inside) || beside_any(r) || within_bands(r)) return true;
  if (size.maxCoeff() < 0.1 * slack_) {
    keep_unclear(r);
    return true;
  }
  const auto [first, second] = halves(r);
  return settle_part(first) && settle_part(second);
}

// Whether an edge is that near, which is no further than surely far.
bool SlackGauge::is_near(double squared_reach, const Vec2& p) {
  if (nearest_ < edges_.size() && edges_[nearest_]->is_within(squared_reach, p)) return true;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (out_of_reach(*edges_[i], p) || !edges_[i]->is_within(squared_reach, p)) continue;
    nearest_ = i;
    return true;
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
  for (const CoverEdge* edge : place_.near()) {
    if (!out_of_reach(*edge, r.min) && !out_of_reach(*edge, r.max) && beside(r, *edge)) {
      return true;
    }
  }
  return false;
}

// Whether no edge meets the rectangle, whose middle is inside, or one alone, which cuts it into
// halves: those outside are surely near the edge if their corners are, since they are convex.
bool SlackGauge::within_halves(const Rectangle& r, bool middle_inside) {
  const CoverEdge* cut = nullptr;
  for (const CoverEdge* edge : place_.beside()) {
    if (!may_meet(*edge, r)) continue;
    if (cut) return false;
    cut = edge;
  }
  if (!cut) return middle_inside;
  if (holds(r, cut->low) || holds(r, cut->high)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 p = corner(r, i);
    if (!cut->is_within(near_squared_, p) && !place_.is_inside(p)) return false;
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
           (place_.is_inside(0.5 * (band.min + band.max)) && clear_of_edges(band));
  };
  for (const CoverEdge* edge : place_.near()) {
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
  const double pad = touching_;
  for (const Rectangle& u : unclear_) {
    if (u.min.x() <= r.max.x() + pad && r.min.x() <= u.max.x() + pad &&
        u.min.y() <= r.max.y() + pad && r.min.y() <= u.max.y() + pad) {
      return true;
    }
  }
  return false;
}

bool SlackGauge::allows(const Rectangle& r) {
  gather(r);
  return allows_part(r);
}

// What touches little that is unclear is halved down to that without a look at all edges: what they
// would tell at once, its parts tell too.
bool SlackGauge::allows_part(const Rectangle& r) {
  if (!touches_unclear(r)) return true;
  const Vec2 size = r.max - r.min;
  const double radius = radius_of(size);
  const bool few = edges_.size() <= kManyEdges;
  const bool much = few && size.maxCoeff() < kMuch * unclear_size_;
  // A large one that no edge meets is settled at once, others by their parts.
  if (much && radius > slack_ && clear_of_edges(r)) {
    const Vec2 centre = 0.5 * (r.min + r.max);
    if (place_.is_inside(centre)) return true;
    if (!place_.is_near(near_squared_, centre)) return false;
  }
  if (!few || radius <= slack_) {
    const Vec2 centre = 0.5 * (r.min + r.max);
    const double reach = (1 - 1e-9) * (slack_ - radius);
    if (reach > 0 && place_.is_near(reach * reach, centre)) return true;
    const bool inside = place_.is_inside(centre);
    if (inside && radius <= slack_) return true;
    if (!inside && !place_.is_near(slack_ * slack_, centre)) return false;
    if (radius < kLeaf * slack_) return false;
    // A part beside an edge or wholly inside would be halved down to the slack for nothing.
    if (much && beside_any(r)) return true;
    if (inside && clear_of_edges(r)) return true;
  }
  if (much && within_bands(r)) return true;
  const auto [first, second] = halves(r);
  return allows_part(first) && allows_part(second);
}

bool SlackGauge::is_inside(const Vec2& p) {
  winding_.clear();
  bool odd = false;
  for (const CoverEdge* edge : meeting()) {
    if (!edge->is_right_of(p)) continue;
    winding_.count(*edge);
    odd = !odd;
  }
  return odd || winding_.inside();
}

bool SlackGauge::clear_of_edges(const Rectangle& r) const {
  const auto edges = place_.beside();
  return std::none_of(edges.begin(), edges.end(),
                      [&](const CoverEdge* edge) { return may_meet(*edge, r); });
}

}  // namespace geom
