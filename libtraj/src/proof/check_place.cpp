#include "check_place.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr int kDeepest = 60;         // halvings; 2^-60 of a segment is below any rounding
constexpr double kSmallest = 2e-10;  // metres: a piece this small that is not clear collides
// A piece with more obstacles around it is halved before any is looked at: the box around a curve
// that swings far out holds a good part of the map, and the curve comes near little of that.
constexpr std::size_t kMany = 64;
constexpr int kMostCuts = 8;      // halvings of a piece whose collision is reported
constexpr double kBeside = 1e-8;  // metres: what is refused comes within 1e-9 m of an obstacle

// Rounded outward.
geom::Aabb moved(const geom::Aabb& box, const Vec3& by) {
  geom::Aabb out{box.min + by, box.max + by};
  for (int i = 0; i < 3; ++i) {
    out.min[i] = geom::next_down(out.min[i]);
    out.max[i] = geom::next_up(out.max[i]);
  }
  return out;
}

geom::Aabb padded(const geom::Aabb& box, const Vec3& pad) { return {box.min - pad, box.max + pad}; }

// The box that surely holds the curve, whose points carry the error of `depth` halvings, and what
// is flown beside it.
geom::Aabb sure_box(const Piece& piece, int depth, double scale) {
  const Vec3 pad = Vec3::Constant(1e-15 * (depth + 2) * scale + 1e-300);
  return padded(hull_box(piece.q), pad + piece.stray * (1 + 1e-15));
}

bool too_small(const Piece& piece, int depth) {
  const geom::Aabb box = hull_box(piece.q);
  return (box.max - box.min).maxCoeff() < kSmallest || depth >= kDeepest;
}

// The first time that cannot be shown clear of every grown box by place or by time, or nothing.
// Works relative to an origin on the curve, so errors scale with the piece and not with its
// coordinates.
std::optional<double> first_touch(const Piece& piece, const std::vector<BoxInTime>& near, int depth,
                                  double scale) {
  const geom::Aabb box = sure_box(piece, depth, scale);
  std::vector<BoxInTime> rest;
  for (const BoxInTime& grown : near) {
    if (geom::overlap(box, grown.box) && grown.time.meets(time_of(piece))) rest.push_back(grown);
  }
  if (rest.empty()) return std::nullopt;
  if (too_small(piece, depth)) return piece.middle();
  const auto [l, r] = piece.halved();
  if (const auto t = first_touch(l, rest, depth + 1, scale)) return t;
  return first_touch(r, rest, depth + 1, scale);
}

// The same against being inside closed bounds.
std::optional<double> first_outside(const Piece& piece, const geom::Aabb& inner, int depth,
                                    double scale) {
  const geom::Aabb box = sure_box(piece, depth, scale);
  if (geom::contains(inner, box.min) && geom::contains(inner, box.max)) return std::nullopt;
  if (too_small(piece, depth)) return piece.middle();
  const auto [l, r] = piece.halved();
  if (const auto t = first_outside(l, inner, depth + 1, scale)) return t;
  return first_outside(r, inner, depth + 1, scale);
}

Piece around(const Vec3& origin, Piece piece) {
  for (Vec3& p : piece.q) p -= origin;
  return piece;
}

double largest_coordinate(const Piece& piece) {
  double m = 0;
  for (const Vec3& p : piece.q) m = std::max(m, p.cwiseAbs().maxCoeff());
  return m;
}

bool on_the_line_between_its_ends(const Piece& piece) {
  return std::all_of(piece.q.begin(), piece.q.end(),
                     [&](const Vec3& p) { return p == piece.q.front() || p == piece.q.back(); });
}

// The proof that one piece of a curve is clear of a scene.
class TouchSearch {
 public:
  TouchSearch(const geom::CollisionScene& scene, const BoxTimes& times, const Piece& piece)
      : scene_(scene),
        times_(times),
        origin_(piece.q[0]),
        whole_(around(origin_, piece)),
        scale_(largest_coordinate(whole_)) {}

  bool touches() { return touch(whole_, region_of(whole_, 0), 0).has_value(); }
  std::size_t looked_at() const { return looked_at_; }

 private:
  // The first time in `piece` that cannot be shown clear. `region` holds it, in the map's frame.
  std::optional<double> touch(const Piece& piece, const geom::Aabb& region, int depth) {
    const auto boxes = too_small(piece, depth) ? scene_.boxes_meeting(region)
                                               : scene_.boxes_meeting(region, kMany);
    looked_at_ += boxes ? boxes->size() : kMany;
    if (boxes) {
      std::vector<BoxInTime> near;
      for (const std::size_t i : *boxes) {
        near.push_back({moved(scene_.grown(i), -origin_), times_.of(i)});
      }
      return first_touch(piece, near, depth, scale_);
    }
    const auto [l, r] = piece.halved();
    if (const auto t = touch(l, region_of(l, depth + 1), depth + 1)) return t;
    return touch(r, region_of(r, depth + 1), depth + 1);
  }

  geom::Aabb region_of(const Piece& piece, int depth) const {
    return moved(sure_box(piece, depth, scale_), origin_);
  }

  const geom::CollisionScene& scene_;
  const BoxTimes& times_;
  Vec3 origin_;
  Piece whole_;
  double scale_;
  std::size_t looked_at_ = 0;
};

bool touches(const geom::CollisionScene& scene, const BoxTimes& times, const Piece& piece,
             CheckResult& result) {
  if (piece.stray.isZero(0) && on_the_line_between_its_ends(piece)) {
    const bool hits = scene.hits(piece.q.front(), piece.q.back());
    if (!hits || !times.count()) return hits;  // else it may be at another time
  }
  TouchSearch search(scene, times, piece);
  const bool touching = search.touches();
  result.looked_at += search.looked_at();
  return touching;
}

bool leaves(const geom::CollisionScene& scene, const Piece& piece) {
  if (!scene.free_bounds()) return true;
  const geom::Aabb box = padded(hull_box(piece.q), piece.stray * (1 + 1e-15));
  if (scene.inside_bounds(box.min) && scene.inside_bounds(box.max)) return false;
  const Vec3 origin = piece.q[0];
  geom::Aabb inner{scene.free_bounds()->min - origin, scene.free_bounds()->max - origin};
  for (int i = 0; i < 3; ++i) {
    inner.min[i] = geom::next_up(inner.min[i]);
    inner.max[i] = geom::next_down(inner.max[i]);
  }
  const Piece local = around(origin, piece);
  return first_outside(local, inner, 0, largest_coordinate(local)).has_value();
}

double depth_in(const geom::Aabb& box, const Vec3& p) {
  return std::min((p - box.min).minCoeff(), (box.max - p).minCoeff());
}

// An upper bound of that along a piece: a box is as deep as the nearest of its faces, and along a
// face's axis the piece reaches no further than its control points.
double most_depth_in(const geom::Aabb& box, const geom::Aabb& hull) {
  return std::min((hull.max - box.min).minCoeff(), (box.max - hull.min).minCoeff());
}

double way_out(const geom::CollisionScene& scene, const Vec3& p) {
  if (!scene.free_bounds()) return scene.half().maxCoeff();
  return -depth_in(*scene.free_bounds(), p);
}

// A piece that may collide, and which of the lists of grown boxes has those around it.
struct Part : Piece {
  std::size_t list = 0;

  std::pair<Part, Part> halved() const {
    const auto [l, r] = Piece::halved();
    return {{l, list}, {r, list}};
  }
};

// How deep the curve is in obstacles while they are there, by parts with few around them.
class DepthSearch {
 public:
  DepthSearch(const geom::CollisionScene& scene, const BoxTimes& times)
      : scene_(scene), times_(times) {}

  // Cut up to so many times until few boxes are left; parts without any are left out.
  void add(const Piece& piece, int cuts = kMostCuts) {
    stray_ = stray_.cwiseMax(piece.stray);
    const geom::Aabb region = beside(padded(hull_box(piece.q), piece.stray), kBeside);
    const auto few = scene_.boxes_meeting(region, kMany);
    if (!few && cuts > 0) {
      looked_at_ += kMany;
      const auto [l, r] = piece.halved();
      add(l, cuts - 1);
      return add(r, cuts - 1);
    }
    std::vector<BoxInTime> list;
    for (const std::size_t i : few ? *few : scene_.boxes_meeting(region)) {
      list.push_back({padded(scene_.grown(i), piece.stray), times_.of(i)});
    }
    looked_at_ += list.size();
    if (list.empty()) return;
    parts_.push_back({piece, lists_.size()});
    lists_.push_back(std::move(list));
  }

  std::size_t looked_at() const { return looked_at_; }

  Largest deepest() const {
    Largest worst;
    const auto depth = [&](const Part& part, const Vec3& p) {
      const geom::Aabb hull = hull_box(part.q);
      Estimate e{-kInfinity, -kInfinity};
      for (const auto& [box, time] : lists_[part.list]) {
        if (!time.meets(time_of(part))) continue;
        e.bound = std::max(e.bound, most_depth_in(box, hull));
        if (is_there(time, part.middle())) e.value = std::max(e.value, depth_in(box, p));
      }
      return e;
    };
    search_largest(parts_, 1e-6, depth, worst);
    return worst;
  }

  // The box that is as deep there.
  std::optional<std::size_t> box_at(const Largest& worst) const {
    std::optional<std::size_t> which;
    double most = -kInfinity;
    const double reach = kBeside + std::max(0.0, -worst.value);
    const geom::Aabb around = padded({worst.place, worst.place}, stray_);
    for (const std::size_t i : scene_.boxes_meeting(beside(around, reach))) {
      if (!is_there(times_.of(i), worst.time)) continue;
      const double depth = depth_in(padded(scene_.grown(i), stray_), worst.place);
      if (depth > most) {
        most = depth;
        which = i;
      }
    }
    return which;
  }

 private:
  static bool is_there(const geom::TimeSpan& time, double at) { return time.meets({at, at}); }

  // Wider by that, and by what rounding may have moved its points.
  static geom::Aabb beside(const geom::Aabb& box, double reach) {
    const double far = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    const Vec3 pad = Vec3::Constant(reach + 1e-14 * far);
    return {box.min - pad, box.max + pad};
  }

  const geom::CollisionScene& scene_;
  const BoxTimes& times_;
  std::vector<Part> parts_;
  std::vector<std::vector<BoxInTime>> lists_;
  Vec3 stray_ = Vec3::Zero();  // the largest
  std::size_t looked_at_ = 0;
};

void report_collision(const geom::CollisionScene& scene, const BoxTimes& times,
                      const std::vector<Piece>& bad, CheckResult& result) {
  DepthSearch search(scene, times);
  for (const Piece& piece : bad) search.add(piece);
  result.looked_at += search.looked_at();
  Largest worst = search.deepest();
  // A box that is there for an instant may be at none that was looked at.
  if (worst.value == -kInfinity) worst = {0, bad.front().middle(), middle_of(bad.front().q)};
  result.box = search.box_at(worst);
  note(result, Reason::collision, worst);
}

void report_outside(const geom::CollisionScene& scene, const std::vector<Piece>& bad,
                    CheckResult& result) {
  Largest worst;
  const auto out = [&](const Piece& piece, const Vec3& middle) {
    const double beside = piece.stray.maxCoeff();
    Estimate e{way_out(scene, middle) + beside, -kInfinity};
    for (const Vec3& p : piece.q)
      e.bound = std::max(e.bound, way_out(scene, p) + beside);  // convex
    return e;
  };
  search_largest(bad, 1e-6, out, worst);
  note(result, Reason::bounds, worst);
}

}  // namespace

void note(CheckResult& result, Reason reason, const Largest& worst) {
  result.reason = reason;
  result.time = worst.time;
  result.place = worst.place;
  result.worst = worst.value;
}

void check_place(const geom::CollisionScene& scene, const BoxTimes& times,
                 const std::vector<Piece>& pieces, CheckResult& result) {
  std::vector<Piece> outside;
  std::vector<Piece> colliding;
  for (const Piece& piece : pieces) {
    if (leaves(scene, piece)) outside.push_back(piece);
  }
  if (!outside.empty()) return report_outside(scene, outside, result);
  for (const Piece& piece : pieces) {
    if (touches(scene, times, piece, result)) colliding.push_back(piece);
  }
  if (!colliding.empty()) report_collision(scene, times, colliding, result);
}

}  // namespace traj
