#include "traj/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "traj/bernstein.h"

namespace traj {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDeepest = 60;         // halvings; 2^-60 of a segment is below any rounding
constexpr double kSmallest = 2e-10;  // metres: a piece this small that is not clear collides

template <std::size_t N>
using Points = std::array<Vec3, N>;

// De Casteljau at one half: each of the N - 1 averagings rounds by at most 2^-53 of its value.
template <std::size_t N>
std::pair<Points<N>, Points<N>> halves(Points<N> q) {
  Points<N> left;
  Points<N> right;
  for (std::size_t m = 0; m < N; ++m) {
    left[m] = q[0];
    right[N - 1 - m] = q[N - 1 - m];
    for (std::size_t i = 0; i + 1 + m < N; ++i) q[i] = 0.5 * (q[i] + q[i + 1]);
  }
  return {left, right};
}

template <std::size_t N>
geom::Aabb hull_box(const Points<N>& q) {
  geom::Aabb box{q[0], q[0]};
  for (const Vec3& p : q) box = geom::merged(box, {p, p});
  return box;
}

// The middle of the curve and a ball around it that holds the whole curve.
template <std::size_t N>
double radius_around(const Points<N>& q, const Vec3& middle) {
  double r = 0;
  for (const Vec3& p : q) r = std::max(r, (p - middle).squaredNorm());
  return std::sqrt(r);
}

Vec3 middle_of(const Points<kPoints>& q) { return halves(q).second[0]; }

// A degree-7 piece of a segment, with its place in time.
struct Piece {
  Points<kPoints> q;
  double begin;
  double end;

  double middle() const { return 0.5 * (begin + end); }
  std::pair<Piece, Piece> halved() const {
    const auto [l, r] = halves(q);
    return {{l, begin, middle()}, {r, middle(), end}};
  }
};

// The largest of a function that moves by at most 1 per metre (a depth, a negated distance), by
// branch and bound to `tolerance`. `value(p, needed)` may return anything below `needed` once it
// knows that it stays below. Only what a report says hangs on this, never a verdict.
struct Largest {
  double value = -kInfinity;
  double time = 0;
  Vec3 place = Vec3::Zero();
};

template <class Value>
void search_largest(const std::vector<Piece>& pieces, double tolerance, const Value& value,
                    Largest& best) {
  struct Entry {
    double bound;
    Piece piece;
    bool operator<(const Entry& other) const { return bound < other.bound; }
  };
  std::priority_queue<Entry> open;
  const auto look = [&](const Piece& piece) {
    const Vec3 p = middle_of(piece.q);
    const double r = radius_around(piece.q, p);
    const double v = value(p, best.value - r);
    if (v > best.value) best = {v, piece.middle(), p};
    if (v + r > best.value + tolerance) open.push({v + r, piece});
  };
  for (const Piece& piece : pieces) look(piece);
  for (int i = 0; i < 20000 && !open.empty(); ++i) {
    const Entry top = open.top();
    open.pop();
    if (top.bound <= best.value + tolerance) break;
    const auto [l, r] = top.piece.halved();
    look(l);
    look(r);
  }
}

std::vector<Piece> pieces_of(const Trajectory& trajectory) {
  std::vector<Piece> pieces;
  double t = 0;
  for (const Segment& s : trajectory.segments) {
    pieces.push_back({s.point, t, t + s.duration});
    t += s.duration;
  }
  return pieces;
}

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
  search_largest(
      bad, 1e-6, [&](const Vec3& p, double) { return penetration(scene, boxes, p, nullptr); },
      worst);
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
    search_largest(
        outside, 1e-6, [&](const Vec3& p, double) { return way_out(scene, p); }, worst);
    note(result, "bounds", worst);
  } else if (!colliding.empty()) {
    report_collision(scene, colliding, result);
  }
}

void measure_clearance(const geom::CollisionScene& scene, const std::vector<Piece>& pieces,
                       CheckResult& result) {
  if (scene.map().size() == 0) return;
  Largest best;
  search_largest(
      pieces, 1e-3,
      [&](const Vec3& p, double needed) {
        const auto near = scene.nearest(p, -needed);
        return near ? -near->distance : needed;
      },
      best);
  result.clearance = Extreme{-best.value, best.time};
}

// --- limits ---------------------------------------------------------------------------------

// The largest of a function over the curve whose sublevel sets are convex: on the curve it is at
// most the largest at the control points. Returns false when `limit` cannot be shown to hold.
template <std::size_t N, class Value>
bool bounded(const Points<N>& q, double begin, double end, int depth, double slack, double limit,
             const Value& value, Extreme& best) {
  const double at_begin = value(q.front());
  const double at_end = value(q.back());
  if (at_begin > best.value) best = {at_begin, begin};
  if (at_end > best.value) best = {at_end, end};
  double upper = 0;
  for (const Vec3& p : q) upper = std::max(upper, value(p));
  upper += slack;
  const bool decided = upper <= limit || best.value > limit;
  if (decided && upper <= best.value * (1 + 1e-4) + slack) return upper <= limit;
  if (depth == 40) return upper <= limit;
  const auto [l, r] = halves(q);
  const double middle = 0.5 * (begin + end);
  const bool left = bounded(l, begin, middle, depth + 1, slack, limit, value, best);
  return bounded(r, middle, end, depth + 1, slack, limit, value, best) && left;
}

template <std::size_t N>
double largest_norm(const Points<N>& q) {
  double m = 0;
  for (const Vec3& p : q) m = std::max(m, p.norm());
  return m;
}

double tilt_of(const Vec3& a) { return std::atan2(std::hypot(a.x(), a.y()), a.z() + kGravity); }

struct LimitVerdicts {
  bool speed = true;
  bool acceleration = true;
  bool jerk = true;
  bool tilt = true;
  bool horizontal = true;
  bool vertical = true;
  bool thrust = true;
};

void check_segment_limits(const Segment& s, double begin, const CheckOptions& options,
                          CheckResult& result, LimitVerdicts& ok) {
  const auto with_slack = [&](const std::optional<double>& limit) {
    return limit ? *limit * (1 + options.limit_slack) : kInfinity;
  };
  const auto norm = [](const Vec3& p) { return p.norm(); };
  const auto v = velocity_points(s);
  const auto a = acceleration_points(s);
  const auto j = jerk_points(s);
  // Errors of the differences (each a subtraction and a product) and of up to 40 halvings.
  const double eps = 1e-15;
  const double v_error = 50 * eps * largest_norm(v);
  const double a_error = 12 / s.duration * 4 * eps * largest_norm(v) + 50 * eps * largest_norm(a);
  const double j_error = 10 / s.duration * a_error + 50 * eps * largest_norm(j);
  const double end = begin + s.duration;
  const Limits& limits = options.limits;
  ok.speed &= bounded(v, begin, end, 0, v_error, with_slack(limits.vmax), norm, result.speed);
  if (limits.vmax_h) {
    const auto across = [](const Vec3& p) { return std::sqrt(p.x() * p.x() + p.y() * p.y()); };
    ok.horizontal &= bounded(v, begin, end, 0, v_error, with_slack(limits.vmax_h), across,
                             result.horizontal_speed);
  }
  if (limits.vmax_v) {
    const auto up = [](const Vec3& p) { return std::abs(p.z()); };
    ok.vertical &=
        bounded(v, begin, end, 0, v_error, with_slack(limits.vmax_v), up, result.vertical_speed);
  }
  if (limits.thrust) {
    const auto thrust = [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() + kGravity).norm(); };
    ok.thrust &= bounded(a, begin, end, 0, a_error + 1e-14, with_slack(limits.thrust), thrust,
                         result.thrust);
  }
  ok.acceleration &=
      bounded(a, begin, end, 0, a_error, with_slack(limits.amax), norm, result.acceleration);
  ok.jerk &= bounded(j, begin, end, 0, j_error, with_slack(limits.jmax), norm, result.jerk);
  if (limits.tilt) {
    const double t_error = 4 * a_error / kGravity + 1e-15;
    ok.tilt &= bounded(a, begin, end, 0, t_error, with_slack(limits.tilt), tilt_of, result.tilt);
  }
}

void check_limits(const Trajectory& trajectory, const CheckOptions& options, CheckResult& result) {
  LimitVerdicts ok;
  double t = 0;
  for (const Segment& s : trajectory.segments) {
    check_segment_limits(s, t, options, result, ok);
    t += s.duration;
  }
  if (!result.reason.empty()) return;
  const auto violated = [&](bool holds, std::string_view reason, const Extreme& at) {
    if (holds || !result.reason.empty()) return;
    note(result, reason, {at.value, at.time, evaluate(trajectory, at.time).position});
  };
  violated(ok.speed, "speed", result.speed);
  violated(ok.acceleration, "acceleration", result.acceleration);
  violated(ok.jerk, "jerk", result.jerk);
  violated(ok.tilt, "tilt", result.tilt);
  violated(ok.horizontal, "horizontal_speed", result.horizontal_speed);
  violated(ok.vertical, "vertical_speed", result.vertical_speed);
  violated(ok.thrust, "thrust", result.thrust);
}

// --- joints ---------------------------------------------------------------------------------

bool durations_are_sound(const Trajectory& trajectory, CheckResult& result) {
  for (const Segment& s : trajectory.segments) {
    bool sound = std::isfinite(s.duration) && s.duration > 0;
    for (const Vec3& p : s.point) sound = sound && p.allFinite();
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
  measure_clearance(scene, pieces, result);
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
    return Piece{{a, a, a, a, b, b, b, b}, index, index + 1};
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
  measure_clearance(scene, pieces, result);
  result.ok = result.reason.empty();
  return result;
}

}  // namespace traj
