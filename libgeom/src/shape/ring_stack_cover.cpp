// cover() of geom/shape/ring_stack.h.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/shape/convex_outline.h"
#include "geom/shape/cover.h"
#include "shape/ring_stack.h"

namespace geom {
namespace {

constexpr std::size_t kMostBoxes = 1000000;
constexpr double kOfHeight = 0.45;  // of the slack: what a slab may lose by its height
constexpr double kOfEnd = 1e-3;     // how thick the ends of a slab are taken to be

struct Edge {
  Vec3 low;  // by z
  Vec3 high;

  Vec2 at(double z) const {
    const double rise = high.z() - low.z();
    if (!(rise > 0)) return low.head<2>();
    const double t = std::clamp((z - low.z()) / rise, 0.0, 1.0);
    return low.head<2>() + t * (high.head<2>() - low.head<2>());
  }
};

std::vector<Edge> edges_of(const RingStack& solid, int axis) {
  std::vector<Vec3> p;
  p.reserve(solid.corners.size());
  for (const Vec3& c : solid.corners) p.push_back({c[(axis + 1) % 3], c[(axis + 2) % 3], c[axis]});
  std::vector<Edge> edges;
  edges.reserve(2 * p.size());
  const auto add = [&](const Vec3& a, const Vec3& b) {
    const bool up = a.z() <= b.z();
    edges.push_back({up ? a : b, up ? b : a});
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t ring = i / solid.sides * solid.sides;
    add(p[i], p[ring + (i + 1 - ring) % solid.sides]);
    if (i + solid.sides < p.size()) add(p[i], p[i + solid.sides]);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.low.z() < b.low.z(); });
  return edges;
}

// The solid in slabs [z0, z1] from its lowest point up.
class Slabs {
 public:
  Slabs(const RingStack& solid, int axis, double slack) : slack_(slack), axis_(axis) {
    edges_ = edges_of(solid, axis);
    low_ = edges_.front().low.z();
    high_ = low_;
    for (const Edge& e : edges_) high_ = std::max(high_, e.high.z());
  }

  // Nothing where it takes `most` boxes or more.
  std::optional<std::vector<Aabb>> cover(std::size_t most) {
    std::vector<Aabb> out;
    for (double z0 = low_;;) {
      const double z1 = furthest(z0);
      const double loss = std::min(z1 - z0, loss_in(z0, z1).value_or(z1 - z0));
      for (const Rectangle& r : geom::cover({outline(z0, z1), {}}, 0.97 * slack_ - loss)) {
        if (out.size() + 1 >= most) return std::nullopt;
        out.push_back(box(r, z0, z1));
      }
      if (z1 >= high_) return out;
      z0 = z1;
      pass(z0);
    }
  }

 private:
  // Forgets the edges that end below z0.
  void pass(double z0) {
    while (next_ < edges_.size() && edges_[next_].low.z() <= z0) begun_.push_back(&edges_[next_++]);
    std::erase_if(begun_, [&](const Edge* e) { return e->high.z() < z0; });
  }

  template <class F>
  void for_each_in(double z0, double z1, const F& f) const {
    for (const Edge* e : begun_) {
      if (e->high.z() >= z0 && e->low.z() <= z1) f(*e);
    }
    for (std::size_t i = next_; i < edges_.size() && edges_[i].low.z() <= z1; ++i) {
      if (edges_[i].high.z() >= z0) f(edges_[i]);
    }
  }

  // Around what of the solid lies in the slab, in plan.
  std::vector<Vec2> outline(double z0, double z1) const {
    std::vector<Vec2> points;
    for_each_in(z0, z1, [&](const Edge& e) {
      points.push_back(e.at(z0));
      points.push_back(e.at(z1));
    });
    return convex_outline(std::move(points));
  }

  // How far a point of outline x slab may be from the solid, at most. The distance from a convex
  // body is largest at a corner, and is at most that from the body's section at the same height.
  // Nothing where it is more than the slab's share of the slack.
  std::optional<double> loss_in(double z0, double z1) const {
    const double thick = kOfEnd * slack_;
    const Polygon at_low{outline(z0, std::min(z1, z0 + thick)), {}};
    const Polygon at_high{outline(std::max(z0, z1 - thick), z1), {}};
    double loss = 0;
    for (const Vec2& p : outline(z0, z1)) {
      loss = std::max({loss, distance(at_low, p), distance(at_high, p)});
      if (loss > kOfHeight * slack_) return std::nullopt;
    }
    return loss + thick;
  }

  // A slab no higher than the share of the slack is always right: what is above or below a point of
  // its outline is that near.
  double furthest(double z0) const {
    if (z0 == low_ && loss_in(z0, high_)) return high_;
    double good = std::min(high_, z0 + kOfHeight * slack_);
    double bad = high_;
    for (double step = good - z0; good < high_; step *= 2) {
      const double next = std::min(high_, good + step);
      if (!loss_in(z0, next)) {
        bad = next;
        break;
      }
      good = next;
    }
    for (int i = 0; i < 5 && good < high_; ++i) {
      const double middle = 0.5 * (good + bad);
      (loss_in(z0, middle) ? good : bad) = middle;
    }
    return good;
  }

  Aabb box(const Rectangle& r, double z0, double z1) const {
    const double pad = 1e-9 + 1e-14 * std::max(std::abs(z0), std::abs(z1));
    Aabb out;
    for (int i = 0; i < 2; ++i) {
      out.min[(axis_ + 1 + i) % 3] = r.min[i];
      out.max[(axis_ + 1 + i) % 3] = r.max[i];
    }
    out.min[axis_] = z0 - pad;
    out.max[axis_] = z1 + pad;
    return out;
  }

  double slack_;
  int axis_;
  std::vector<Edge> edges_;         // by their lower end
  std::size_t next_ = 0;            // the first edge that begins above the slab's lower end
  std::vector<const Edge*> begun_;  // those before it that reach the slab
  double low_ = 0;
  double high_ = 0;
};

void require(const RingStack& solid, double slack) {
  double largest = 0;
  for (const Vec3& c : solid.corners) largest = std::max(largest, c.cwiseAbs().maxCoeff());
  const double least = std::max(1e-5, 1e-8 * largest);
  if (slack >= least && slack <= kLargestCoordinate && largest <= kLargestCoordinate) return;
  throw InputError("slack", {.expected = fmt::format(
                                 "metres from {} for a body that reaches {:.6g} m from its middle",
                                 least, largest),
                             .found = fmt::to_string(slack)});
}

}  // namespace

std::vector<Aabb> cover(const RingStack& solid, double slack) {
  require(solid, slack);
  std::optional<std::vector<Aabb>> best;
  for (const int axis : {2, 0, 1}) {
    auto found = Slabs(solid, axis, slack).cover(best ? best->size() : kMostBoxes + 1);
    if (found) best = std::move(found);
    if (best && best->size() == 1) break;
  }
  if (!best) {
    throw InputError("slack", {.says = fmt::format(
                                   "a turned or round body needs more than {} boxes of slack {} m",
                                   kMostBoxes, slack),
                               .advice = "give more slack"});
  }
  return *best;
}

}  // namespace geom
