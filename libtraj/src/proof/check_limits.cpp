#include "check_limits.h"

#include <algorithm>
#include <cmath>

#include "curve/bernstein.h"
#include "curve/curve_piece.h"
#include "curve/portable_math.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

constexpr double kEps = 1e-15;
constexpr int kDeepest = 40;      // halvings
constexpr int kMostCuts = 20000;  // of a segment; what is not shown to hold by then is refused

// The largest of a value over control points, or `least`. Where one is not a number, infinity: a
// plain maximum would pass it by, and what is not known would read as within the limit.
template <std::size_t N, class Value>
double largest(const Points<N>& q, const Value& value, double least = 0) {
  for (const Vec3& p : q) {
    const double v = value(p);
    if (std::isnan(v)) return kInfinity;
    least = std::max(least, v);
  }
  return least;
}

// A quantity over a piece of a curve whose sublevel sets are convex: on the curve it is at most the
// largest at the control points. `slack` is what rounding may have taken from it.
template <std::size_t N, class Value>
struct ConvexPiece {
  Points<N> q;
  const Value& value;
  double slack;

  double first() const { return value(q.front()); }
  double last() const { return value(q.back()); }
  double upper() const { return largest(q, value) + slack; }
  std::pair<ConvexPiece, ConvexPiece> halved() const {
    const auto [l, r] = halves(q);
    return {{l, value, slack}, {r, value, slack}};
  }
};

// |j x f| / |f|^2, the rate at which a direction f turns whose derivative is j: both products are
// Bernstein forms of their own.
struct TurnPiece {
  Points<10> cross;   // of degree 9
  Points<11> square;  // of degree 10, in x
  double cross_error;
  double square_error;
  double slack;  // rad/s: of what is reported, not of the verdict

  static double ratio(double cross, double square) {
    return square > 0 ? cross / square : (cross > 0 ? kInfinity : 0);
  }
  double first() const { return ratio(cross.front().norm(), square.front().x()); }
  double last() const { return ratio(cross.back().norm(), square.back().x()); }
  double upper() const {
    const double most = largest(cross, [](const Vec3& p) { return p.norm(); });
    const double least = -largest(
        square, [](const Vec3& p) { return -p.x(); }, -kInfinity);
    const double sure = least - square_error;
    return sure > 0 ? (most + cross_error) / sure * (1 + kEps) : kInfinity;
  }
  std::pair<TurnPiece, TurnPiece> halved() const {
    const auto [cl, cr] = halves(cross);
    const auto [sl, sr] = halves(square);
    return {{cl, sl, cross_error, square_error, slack}, {cr, sr, cross_error, square_error, slack}};
  }
};

// What is asked of a quantity over a segment.
struct Bound {
  double limit;
  Extreme& best;         // the largest so far
  int left = kMostCuts;  // a thrust of about nothing, as in free fall, turns at any rate
};

struct Stretch {
  double begin;  // seconds
  double end;
  int depth = 0;  // halvings
};

// The largest over the piece, to a relative 1e-4. Returns false when the limit cannot be shown to
// hold.
template <class Quantity>
bool bounded(const Quantity& piece, const Stretch& stretch, Bound& bound) {
  const auto& [begin, end, depth] = stretch;
  Extreme& best = bound.best;
  const double at_begin = piece.first();
  const double at_end = piece.last();
  if (at_begin > best.value) best = {at_begin, begin};
  if (at_end > best.value) best = {at_end, end};
  const double upper = piece.upper();
  const bool decided = upper <= bound.limit || best.value > bound.limit;
  if (decided && upper <= best.value * (1 + 1e-4) + piece.slack) return upper <= bound.limit;
  if (depth == kDeepest || bound.left-- <= 0) return upper <= bound.limit;
  const auto [l, r] = piece.halved();
  const double middle = 0.5 * (begin + end);
  const bool left = bounded(l, Stretch{begin, middle, depth + 1}, bound);
  return bounded(r, Stretch{middle, end, depth + 1}, bound) && left;
}

double across(const Vec3& p) { return std::sqrt(p.x() * p.x() + p.y() * p.y()); }

// The angle of f = a + g from upright, where f may be `error` off.
struct TiltPiece {
  Points<6> f;
  double error;
  double slack = 4 * kEps;

  double most_of(const Vec3& p) const { return angle_of(p.z() - error, across(p) + error); }
  double first() const { return most_of(f.front()); }
  double last() const { return most_of(f.back()); }
  double upper() const {
    const bool upright = std::all_of(f.begin(), f.end(), [&](auto& p) { return p.z() > error; });
    return (upright ? by_points() : by_ball()) + slack;
  }
  double by_points() const {  // a cone of less than a right angle is convex
    return largest(f, [this](const Vec3& p) { return most_of(p); });
  }
  double by_ball() const {
    const Vec3 middle = 0.5 * (f.front() + f.back());
    const double r = radius_around(f, middle) + 2 * error;
    const double far = std::sqrt(std::max(0.0, middle.squaredNorm() - r * r));
    if (far == 0) return kPi;
    return std::min(kPi, angle_of(middle.z(), across(middle)) + angle_of(far, r));
  }
  std::pair<TiltPiece, TiltPiece> halved() const {
    const auto [l, r] = halves(f);
    return {{l, error}, {r, error}};
  }
};

Points<6> thrust_points(Points<6> a) {
  for (Vec3& p : a) p.z() += kGravity;
  return a;
}

template <std::size_t N>
double largest_norm(const Points<N>& q) {
  return largest(q, [](const Vec3& p) { return p.norm(); });
}

constexpr double choose(int n, int k) {
  double out = 1;
  for (int i = 0; i < k; ++i) out = out * (n - i) / (i + 1);
  return out;
}

// The Bernstein form of the product of two curves; `times` is bilinear.
template <std::size_t N, std::size_t M, class Times>
Points<N + M - 1> product(const Points<N>& a, const Points<M>& b, const Times& times) {
  constexpr int n = static_cast<int>(N) - 1;
  constexpr int m = static_cast<int>(M) - 1;
  Points<N + M - 1> out;
  out.fill(Vec3::Zero());
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= m; ++k) {
      const double weight = choose(n, i) * choose(m, k) / choose(n + m, i + k);
      out[static_cast<std::size_t>(i + k)] +=
          weight * times(a[static_cast<std::size_t>(i)], b[static_cast<std::size_t>(k)]);
    }
  }
  return out;
}

TurnPiece turning(const Points<6>& f, double f_error, const Points<5>& j, double j_error) {
  const double f_most = largest_norm(f);
  const double j_most = largest_norm(j);
  const auto cross = [](const Vec3& x, const Vec3& y) {
    return Vec3(x.y() * y.z() - x.z() * y.y(), x.z() * y.x() - x.x() * y.z(),
                x.x() * y.y() - x.y() * y.x());
  };
  const auto dot = [](const Vec3& x, const Vec3& y) { return Vec3(x.dot(y), 0, 0); };
  const double cross_error = f_most * j_error + j_most * f_error + 100 * kEps * f_most * j_most;
  const double square_error = 2 * f_most * f_error + 100 * kEps * f_most * f_most;
  // No halving takes these errors away, so no digits below them are looked for.
  const double slack = 1e-9 + (cross_error + square_error * j_most) / kGravity;
  return {product(f, j, cross), product(f, f, dot), cross_error, square_error, slack};
}

double norm(const Vec3& p) { return p.norm(); }
double up(const Vec3& p) { return std::abs(p.z()); }

class LimitCheck {
 public:
  LimitCheck(const CheckOptions& options, CheckResult& result)
      : options_(options), result_(result) {}

  void add(const Segment& s, const Stray& stray) {
    duration_ = s.duration;
    const auto v = velocity_points(s);
    const auto a = acceleration_points(s);
    const auto j = jerk_points(s);
    // Errors of the differences (each a subtraction and a product) and of up to 40 halvings.
    const double v_rounded = 50 * kEps * largest_norm(v);
    const double a_rounded =
        12 / s.duration * 4 * kEps * largest_norm(v) + 50 * kEps * largest_norm(a);
    const double j_rounded = 10 / s.duration * a_rounded + 50 * kEps * largest_norm(j);
    const double v_error = v_rounded + stray.velocity;
    const double a_error = a_rounded + stray.acceleration;
    const double j_error = j_rounded + stray.jerk;
    convex(Limit::speed, v, norm, v_error);
    convex(Limit::horizontal_speed, v, across, v_error);
    convex(Limit::vertical_speed, v, up, v_error);
    convex(Limit::acceleration, a, norm, a_error);
    const auto f = thrust_points(a);
    const double f_error = a_error + 10 * kEps;
    convex(Limit::thrust, f, norm, f_error);
    holds(Limit::tilt, TiltPiece{f, f_error});
    convex(Limit::jerk, j, norm, j_error);
    holds(Limit::body_rate, turning(f, f_error, j, j_error));
    if (s.yaw) add_yaw(s, stray.yaw_rate);
    begin_ += s.duration;
  }

  void report(const Trajectory& trajectory) const {
    if (result_.reason != Reason::none) return;
    report_broken(trajectory);
    if (result_.reason == Reason::none && options_.limits[Limit::yaw_rate]) report_gap(trajectory);
  }

 private:
  void report_broken(const Trajectory& trajectory) const {
    for (const Limit limit : kOrderOfLimits) {
      if (!broken_[limit]) continue;
      const Extreme at = result_.largest[limit].value_or(Extreme{});
      result_.reason = broken(limit);
      result_.worst = at.value;
      result_.time = at.time;
      result_.place = evaluate(trajectory, at.time).position;
      return;
    }
  }

  // A segment without yaw between others: the yaw may have any rate there.
  void report_gap(const Trajectory& trajectory) const {
    const std::optional<std::size_t> gap = gap_in_yaw(trajectory);
    if (!gap) return;
    result_.reason = unmeasured(Limit::yaw_rate);
    for (std::size_t i = 0; i < *gap; ++i) result_.time += trajectory.segments[i].duration;
    result_.place = trajectory.segments[*gap].point.front();
  }

  template <class Quantity>
  void holds(Limit limit, const Quantity& piece) {
    const auto& allowed = options_.limits[limit];
    const double most = allowed ? *allowed * (1 + options_.limit_slack) : kInfinity;
    std::optional<Extreme>& extreme = result_.largest[limit];
    if (!extreme) extreme.emplace();
    Bound bound{most, *extreme};
    if (!bounded(piece, Stretch{begin_, begin_ + duration_}, bound)) broken_[limit] = true;
  }

  template <std::size_t N, class Value>
  void convex(Limit limit, const Points<N>& q, const Value& value, double slack) {
    holds(limit, ConvexPiece<N, Value>{q, value, slack});
  }

  void add_yaw(const Segment& s, double stray) {
    Points<kDegree> rate;
    for (std::size_t i = 0; i < rate.size(); ++i) {
      rate[i] = Vec3::UnitX() * (((*s.yaw)[i + 1] - (*s.yaw)[i]) * kDegree / s.duration);
    }
    double most = 0;
    for (const double y : *s.yaw) most = std::max(most, std::abs(y));
    const double error = 50 * kEps * (largest_norm(rate) + most * kDegree / s.duration) + stray;
    convex(Limit::yaw_rate, rate, norm, error);
  }

  const CheckOptions& options_;
  CheckResult& result_;
  PerLimit<bool> broken_;
  double begin_ = 0;
  double duration_ = 0;
};

}  // namespace

void check_limits(const Trajectory& trajectory, const CheckOptions& options, CheckResult& result) {
  LimitCheck limits(options, result);
  for (std::size_t i = 0; i < trajectory.segments.size(); ++i) {
    limits.add(trajectory.segments[i], options.stray.empty() ? Stray{} : options.stray[i]);
  }
  limits.report(trajectory);
}

}  // namespace traj
