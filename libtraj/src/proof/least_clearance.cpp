#include "least_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <span>
#include <utility>

#include "geom/shape/nearest_share.h"
#include "geom/shape/separation.h"

namespace traj {
namespace {

constexpr std::size_t kMany = 16;   // boxes around a part that is halved first
constexpr int kMostParts = 20000;   // that are halved; others meet all boxes around them
constexpr int kDeepest = 60;        // halvings of a curve beside a few boxes
constexpr double kClose = 1e-3;     // metres
constexpr double kNear = 1;         // metres beyond the nearest box, whenever that is there
constexpr double kFurther = 4;      // times as far, where none so near is there at the time
constexpr double kRounding = 1e-6;  // metres: more than growing rounds

// What is needed of a curve or a leg: how little nearer is not looked for, a ball and a box that
// hold it, and its halves.

constexpr double tolerance(const Piece*) { return kClose; }
constexpr double tolerance(const Leg*) { return 0; }

Vec3 middle_of(const Piece& piece) { return traj::middle_of(piece.q); }
Vec3 middle_of(const Leg& leg) { return 0.5 * (leg.from + leg.to); }

double radius_around(const Piece& piece, const Vec3& middle) {
  return traj::radius_around(piece.q, middle);
}
double radius_around(const Leg& leg, const Vec3&) { return 0.5 * (leg.to - leg.from).norm(); }

geom::Aabb hull_box(const Piece& piece) { return traj::hull_box(piece.q); }
geom::Aabb hull_box(const Leg& leg) {
  return {leg.from.cwiseMin(leg.to), leg.from.cwiseMax(leg.to)};
}

std::pair<Piece, Piece> halved(const Piece& piece) { return piece.halved(); }
std::pair<Leg, Leg> halved(const Leg& leg) {
  const Vec3 middle = middle_of(leg);
  const double time = 0.5 * (leg.begin + leg.end);
  return {{leg.from, middle, leg.begin, time, leg.stray},
          {middle, leg.to, time, leg.end, leg.stray}};
}

double gap_between(const geom::Aabb& a, const geom::Aabb& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0).norm();
}

// How far the curve is from the line between its ends, at most: no further than its points are.
double bulge(const Points<kPoints>& q) {
  const Vec3 step = q.back() - q.front();
  const double squared = step.squaredNorm();
  double most = 0;
  for (std::size_t i = 1; i + 1 < kPoints; ++i) {
    const Vec3 out = q[i] - q.front();
    const double t = squared > 0 ? std::clamp(out.dot(step) / squared, 0.0, 1.0) : 0;
    most = std::max(most, (out - t * step).squaredNorm());
  }
  return std::sqrt(most);
}

// Branch and bound over parts of the way, the most promising first. A part is left out by its
// distance from the box nearest to its middle, for the distance moves by at most 1 per metre. One
// with few boxes around it is measured against each of them; others are halved.
template <class Part>
class Search {
 public:
  Search(const geom::CollisionScene& scene, const BoxTimes& times) : scene_(scene), times_(times) {}

  // Nothing where no box is there at any of these times.
  std::optional<Extreme> over(const std::vector<Part>& parts) {
    const auto measured = [&](const Part& part) { return measure_around(part); };
    if (times_.count() && std::none_of(parts.begin(), parts.end(), measured)) return std::nullopt;
    for (const Part& part : parts) add(part);
    while (!open_.empty()) {
      const Open next = open_.top();
      open_.pop();
      if (std::max(0.0, next.bound) >= enough()) break;
      look(next.part);
    }
    if (best_.value == kInfinity) return std::nullopt;
    return Extreme{std::max(0.0, best_.value), best_.time};
  }

 private:
  struct Open {
    double bound;  // no more than anywhere on the part
    Part part;
    bool operator<(const Open& other) const { return bound > other.bound; }
  };

  // What is no nearer than this is of no interest.
  double enough() const { return best_.value - tolerance(static_cast<const Part*>(nullptr)); }

  static double beside(const Part& part) { return part.stray.norm(); }

  BoxInTime grown(std::size_t i) const {
    return {geom::grow(scene_.map().box(i), scene_.vehicle().half), times_.of(i)};
  }

  // Measures the boxes near the part that are there at its times. The search needs a first
  // distance, and the nearest box of all may be there at other times. False where there is none.
  bool measure_around(const Part& part) {
    const Vec3 middle = middle_of(part);
    double reach = kNear + scene_.nearest(middle, kInfinity)->distance;
    for (;; reach *= kFurther) {
      const Vec3 pad = Vec3::Constant(reach);
      const auto found = scene_.boxes_meeting({middle - pad, middle + pad});
      std::vector<BoxInTime> then;
      for (const std::size_t i : found) {
        if (times_.of(i).meets({part.begin, part.end})) then.push_back(grown(i));
      }
      measure(part, then);
      if (best_.value < kInfinity) return true;
      if (found.size() == scene_.map().size()) return false;
    }
  }

  // Tells most boxes that need not be grown exactly, which takes longer.
  bool may_matter(const Leg& leg, const geom::Aabb&, std::size_t i) const {
    return geom::distance(leg.from, leg.to, about(i)) - beside(leg) < enough();
  }
  bool may_matter(const Piece& piece, const geom::Aabb& hull, std::size_t i) const {
    return gap_between(hull, about(i)) - beside(piece) < enough();
  }

  // No smaller than grown.
  geom::Aabb about(std::size_t i) const {
    const geom::Aabb& box = scene_.map().box(i);
    const Vec3 half = scene_.vehicle().half + Vec3::Constant(kRounding);
    return {box.min - half, box.max + half};
  }

  // Whether surely no obstacle is nearer to the curve than the best: asked first, as the search for
  // the nearest one builds the trees around it, however far that is. Legs cross more of the map
  // than their hull tells.
  bool surely_further(const Leg&) const { return false; }
  bool surely_further(const Piece& piece) const {
    if (best_.value == kInfinity) return false;
    const geom::Aabb hull = hull_box(piece);
    const Vec3 pad = Vec3::Constant(std::max(0.0, best_.value) + beside(piece) + kRounding);
    return scene_.boxes_meeting({hull.min - pad, hull.max + pad}, 0).has_value();
  }

  void add(const Part& part) {
    if (surely_further(part)) return;
    const Vec3 middle = middle_of(part);
    const double reach = radius_around(part, middle) + beside(part);
    const auto near = scene_.nearest(middle, reach + enough());
    if (!near) return;
    measure(part, std::array{grown(near->box)});
    const double bound = near->distance - reach;
    if (bound < enough()) open_.push({bound, part});
  }

  void look(const Part& part) {
    const double reach = enough() + beside(part);
    const geom::Aabb hull = hull_box(part);
    const Vec3 pad = Vec3::Constant(reach);
    const geom::Aabb region{hull.min - pad, hull.max + pad};
    // Halving what is small beside its surroundings would leave as many boxes around it.
    const bool large = (hull.max - hull.min).norm() > std::max(reach, kClose);
    const auto found = large && halvings_ < kMostParts ? scene_.boxes_meeting(region, kMany)
                                                       : scene_.boxes_meeting(region);
    if (!found) {
      const auto [first, second] = halved(part);
      add(first);
      add(second);
      ++halvings_;
      return;
    }
    std::vector<BoxInTime> near;
    for (const std::size_t i : *found) {
      if (may_matter(part, hull, i)) near.push_back(grown(i));
    }
    measure(part, near);
  }

  void measure(const Leg& leg, std::span<const BoxInTime> near) {
    for (const auto& [box, time] : near) {
      const double t = geom::nearest_share(leg.from, leg.to, box);
      const double value = geom::distance(leg.from + t * (leg.to - leg.from), box) - beside(leg);
      if (value < best_.value) best_ = {value, leg.begin + t * (leg.end - leg.begin)};
    }
  }

  void measure(const Piece& piece, std::span<const BoxInTime> near) {
    touch(piece.q.front(), piece.begin, beside(piece), near);
    touch(piece.q.back(), piece.end, beside(piece), near);
    refine(piece, near, 0);
  }

  // At a point of the way.
  void touch(const Vec3& p, double time, double beside, std::span<const BoxInTime> near) {
    for (const auto& [box, there] : near) {
      if (!there.meets({time, time})) continue;
      const double value = geom::distance(p, box) - beside;
      if (value < best_.value) best_ = {value, time};
    }
  }

  // Leaves out the boxes that the line between the ends, and what the curve is beside it, keep
  // further from than matters; halves the curve beside the others.
  void refine(const Piece& piece, std::span<const BoxInTime> near, int depth) {
    const double out = bulge(piece.q) + beside(piece);
    std::vector<BoxInTime> rest;
    for (const BoxInTime& one : near) {
      if (!one.time.meets(time_of(piece))) continue;
      const double least = geom::distance(piece.q.front(), piece.q.back(), one.box) - out;
      if (least < enough()) rest.push_back(one);
    }
    if (rest.empty() || depth == kDeepest) return;
    const auto [l, r] = piece.halved();
    touch(r.q.front(), r.begin, beside(piece), rest);
    refine(l, rest, depth + 1);
    refine(r, rest, depth + 1);
  }

  const geom::CollisionScene& scene_;
  const BoxTimes& times_;
  Extreme best_{kInfinity, 0};
  std::priority_queue<Open> open_;
  int halvings_ = 0;
};

template <class Part>
std::optional<Extreme> least(const geom::CollisionScene& scene, const BoxTimes& times,
                             const std::vector<Part>& parts) {
  if (scene.map().size() == 0) return std::nullopt;
  return Search<Part>(scene, times).over(parts);
}

}  // namespace

std::optional<Extreme> least_clearance(const geom::CollisionScene& scene, const BoxTimes& times,
                                       const std::vector<Piece>& pieces) {
  return least(scene, times, pieces);
}

std::optional<Extreme> least_clearance(const geom::CollisionScene& scene,
                                       const std::vector<Leg>& legs) {
  return least(scene, BoxTimes(), legs);
}

}  // namespace traj
