#include "traj/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "check_limits.h"
#include "curve_piece.h"
#include "least_clearance.h"
#include "traj/continuity.h"

namespace traj {
namespace {

constexpr int kDeepest = 60;         // halvings; 2^-60 of a segment is below any rounding
constexpr double kSmallest = 2e-10;  // metres: a piece this small that is not clear collides

// --- collision ------------------------------------------------------------------------------

struct Candidate {
  geom::Aabb box;  // grown, relative to the origin of the proof, rounded outward
  std::size_t index;
};

geom::Aabb relative(const geom::Aabb& box, const Vec3& origin) {
  geom::Aabb out{box.min - origin, box.max - origin};
  for (int i = 0; i < 3; ++i) {
    out.min[i] = std::nextafter(out.min[i], -kInfinity);
    out.max[i] = std::nextafter(out.max[i], kInfinity);
  }
  return out;
}

// The box that surely holds the curve, whose points carry the error of `depth` halvings.
geom::Aabb sure_box(const Points<kPoints>& q, int depth, double scale) {
  const Vec3 pad = Vec3::Constant(1e-15 * (depth + 2) * scale + 1e-300);
  const geom::Aabb box = hull_box(q);
  return {box.min - pad, box.max + pad};
}

// The first time that cannot be shown clear of every candidate, or nothing. Works relative to an
// origin on the curve, so errors scale with the piece and not with its coordinates.
std::optional<double> first_touch(const Piece& piece, const std::vector<Candidate>& near, int depth,
                                  double scale) {
  const geom::Aabb box = sure_box(piece.q, depth, scale);
  std::vector<Candidate> rest;
  for (const Candidate& c : near) {
    if (geom::overlap(box, c.box)) rest.push_back(c);
  }
  if (rest.empty()) return std::nullopt;
  if ((box.max - box.min).maxCoeff() < kSmallest || depth >= kDeepest) return piece.middle();
  const auto [l, r] = piece.halved();
  if (const auto t = first_touch(l, rest, depth + 1, scale)) return t;
  return first_touch(r, rest, depth + 1, scale);
}

// The same against being inside closed bounds.
std::optional<double> first_outside(const Piece& piece, const geom::Aabb& inner, int depth,
                                    double scale) {
  const geom::Aabb box = sure_box(piece.q, depth, scale);
  if (geom::contains(inner, box.min) && geom::contains(inner, box.max)) return std::nullopt;
  if ((box.max - box.min).maxCoeff() < kSmallest || depth >= kDeepest) return piece.middle();
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

bool touches(const geom::CollisionScene& scene, const Piece& piece) {
  if (on_the_line_between_its_ends(piece)) return scene.hits(piece.q.front(), piece.q.back());
  const auto boxes = scene.boxes_meeting(hull_box(piece.q));
  if (boxes.empty()) return false;
  const Vec3 origin = piece.q[0];
  std::vector<Candidate> near;
  for (const std::size_t i : boxes) near.push_back({relative(scene.grown(i), origin), i});
  const Piece local = around(origin, piece);
  return first_touch(local, near, 0, largest_coordinate(local)).has_value();
}

bool leaves(const geom::CollisionScene& scene, const Piece& piece) {
  if (!scene.free_bounds()) return true;
  const geom::Aabb box = hull_box(piece.q);
  if (scene.inside_bounds(box.min) && scene.inside_bounds(box.max)) return false;
  const Vec3 origin = piece.q[0];
  geom::Aabb inner{scene.free_bounds()->min - origin, scene.free_bounds()->max - origin};
  for (int i = 0; i < 3; ++i) {
    inner.min[i] = std::nextafter(inner.min[i], kInfinity);
    inner.max[i] = std::nextafter(inner.max[i], -kInfinity);
  }
  const Piece local = around(origin, piece);
  return first_outside(local, inner, 0, largest_coordinate(local)).has_value();
}

double depth_in(const geom::Aabb& box, const Vec3& p) {
  return std::min((p - box.min).minCoeff(), (box.max - p).minCoeff());
}

// How far `p` is inside the deepest obstacle around it; below 0 outside all.
double penetration(const geom::CollisionScene& scene, const std::vector<std::size_t>& boxes,
                   const Vec3& p, std::optional<std::size_t>* which) {
  double worst = -kInfinity;
  for (const std::size_t i : boxes) {
    const double depth = depth_in(scene.grown(i), p);
    if (depth > worst) {
      worst = depth;
      if (which) *which = i;
    }
  }
  return worst;
}

// An upper bound of that along a piece: a box is as deep as the nearest of its faces, and along a
// face's axis the piece reaches no further than its control points.
double most_penetration(const geom::CollisionScene& scene, const std::vector<std::size_t>& boxes,
                        const Piece& piece) {
  const geom::Aabb hull = hull_box(piece.q);
  double most = -kInfinity;
  for (const std::size_t i : boxes) {
    const geom::Aabb box = scene.grown(i);
    most =
        std::max(most, std::min((hull.max - box.min).minCoeff(), (box.max - hull.min).minCoeff()));
  }
  return most;
}

double way_out(const geom::CollisionScene& scene, const Vec3& p) {
  if (!scene.free_bounds()) return scene.half().maxCoeff();
  return -depth_in(*scene.free_bounds(), p);
}

void note(CheckResult& result, std::string_view reason, const Largest& worst) {
  result.reason = reason;
  result.time = worst.time;
  result.place = worst.place;
  result.worst = worst.value;
}

void report_collision(const geom::CollisionScene& scene, const std::vector<Piece>& bad,
                      CheckResult& result) {
  std::vector<std::size_t> boxes;
  for (const Piece& piece : bad) {
    const auto some = scene.boxes_meeting(hull_box(piece.q));
    boxes.insert(boxes.end(), some.begin(), some.end());
  }
  std::sort(boxes.begin(), boxes.end());
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  Largest worst;
  const auto depth = [&](const Piece& piece, const Vec3& p) {
    return Estimate{penetration(scene, boxes, p, nullptr), most_penetration(scene, boxes, piece)};
  };
  search_largest(bad, 1e-6, depth, worst);
  penetration(scene, boxes, worst.place, &result.box);
  note(result, "collision", worst);
}

void check_place(const geom::CollisionScene& scene, const std::vector<Piece>& pieces,
                 CheckResult& result) {
  std::vector<Piece> outside;
  std::vector<Piece> colliding;
  for (const Piece& piece : pieces) {
    if (leaves(scene, piece)) outside.push_back(piece);
    if (touches(scene, piece)) colliding.push_back(piece);
  }
  if (!outside.empty()) {
    Largest worst;
    const auto out = [&](const Piece& piece, const Vec3& middle) {
      Estimate e{way_out(scene, middle), -kInfinity};
      for (const Vec3& p : piece.q) e.bound = std::max(e.bound, way_out(scene, p));  // convex
      return e;
    };
    search_largest(outside, 1e-6, out, worst);
    note(result, "bounds", worst);
  } else if (!colliding.empty()) {
    report_collision(scene, colliding, result);
  }
}

// --- joints ---------------------------------------------------------------------------------

bool durations_are_sound(const Trajectory& trajectory, CheckResult& result) {
  for (const Segment& s : trajectory.segments) {
    bool sound = std::isfinite(s.duration) && s.duration > 0;
    for (const Vec3& p : s.point) sound = sound && p.allFinite();
    if (s.yaw) {
      sound = sound &&
              std::all_of(s.yaw->begin(), s.yaw->end(), [](double y) { return std::isfinite(y); });
    }
    if (sound) {
      result.duration += s.duration;
      continue;
    }
    note(result, "duration", {s.duration, result.duration, Vec3::Zero()});
    return false;
  }
  if (trajectory.segments.empty()) result.reason = "duration";
  return !trajectory.segments.empty();
}

// Of the yaw (order 0) or its rate at a joint; one without yaw goes with any.
double yaw_jump(const Segment& s, const Segment& next, int order) {
  if (!s.yaw || !next.yaw) return 0;
  const auto& a = *s.yaw;
  const auto& b = *next.yaw;
  if (order == 0) return std::abs(b[0] - a[kDegree]);
  return kDegree *
         std::abs((b[1] - b[0]) / next.duration - (a[kDegree] - a[kDegree - 1]) / s.duration);
}

void check_joints(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const CheckOptions& options, CheckResult& result) {
  double t = 0;
  for (std::size_t i = 0; i + 1 < trajectory.segments.size(); ++i) {
    const Segment& s = trajectory.segments[i];
    const Segment& next = trajectory.segments[i + 1];
    t += s.duration;
    const State a = evaluate(s, s.duration);
    const State b = evaluate(next, 0);
    const double gap = (next.point[0] - s.point[kDegree]).norm();
    if (gap > options.position_gap) {
      note(result, "discontinuous", {gap, t, s.point[kDegree]});
    } else if (const double dv = (b.velocity - a.velocity).norm(); dv > options.velocity_gap) {
      note(result, "discontinuous", {dv, t, s.point[kDegree]});
    } else if (const double da = (b.acceleration - a.acceleration).norm();
               da > options.acceleration_gap) {
      note(result, "discontinuous", {da, t, s.point[kDegree]});
    } else if (const double dy = yaw_jump(s, next, 0); dy > options.yaw_gap) {
      note(result, "discontinuous", {dy, t, s.point[kDegree]});
    } else if (const double dr = yaw_jump(s, next, 1); dr > options.yaw_rate_gap) {
      note(result, "discontinuous", {dr, t, s.point[kDegree]});
    } else if (gap > 0 && scene.hits(s.point[kDegree], next.point[0])) {
      note(result, "collision", {gap, t, s.point[kDegree]});
    } else {
      continue;
    }
    return;
  }
}

}  // namespace

CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const CheckOptions& options) {
  CheckResult result;
  if (!durations_are_sound(trajectory, result)) return result;
  const std::vector<Piece> pieces = pieces_of(trajectory);
  check_joints(scene, trajectory, options, result);
  if (result.reason.empty()) check_place(scene, pieces, result);
  check_limits(trajectory, options, result);
  result.jumps = largest_jumps(trajectory);
  result.clearance = least_clearance(scene, pieces);
  result.ok = result.reason.empty();
  return result;
}

CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const Limits& limits) {
  CheckOptions options;
  options.limits = limits;
  return check(scene, trajectory, options);
}

CheckResult check_path(const geom::CollisionScene& scene, std::span<const Vec3> points) {
  CheckResult result;
  std::vector<Piece> pieces;
  const auto leg = [](const Vec3& a, const Vec3& b, double index) {
    return Piece{{a, a, a, a, b, b, b, b}, index, index + 1};  // decided exactly
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    pieces.push_back(leg(points[i - 1], points[i], static_cast<double>(i - 1)));
  }
  if (points.size() == 1) pieces.push_back(leg(points[0], points[0], 0));
  if (pieces.empty()) {
    result.reason = "no_path";
    return result;
  }
  check_place(scene, pieces, result);
  result.clearance = least_clearance(scene, pieces);
  result.ok = result.reason.empty();
  return result;
}

}  // namespace traj
