#include <algorithm>
#include <limits>

#include "gmp_bernstein.h"
#include "traj/exact_check.h"

namespace traj {
namespace {

using exact::Curve;
using exact::Point;
using exact::Polynomial;
using exact::Whole;
using exact::whole;

constexpr unsigned kDeepest = 60;  // halvings, as deep as the fast check goes

// --- pieces ---------------------------------------------------------------------------------

enum class Verdict { holds, fails_at_begin, fails_at_end, unknown };

// Where a cover stopped: in a piece of the curve, as a part of it.
struct Stop {
  double part = 0;
  bool undecided = false;
};

// Halves `piece` until judge(piece, cover) holds on every part and fills the cover; stops at the
// first part where it does not.
template <class Piece, class Judge>
std::optional<Stop> fill(const Piece& piece, unsigned depth, double begin, Judge& judge,
                         Cover& cover) {
  const double length = std::ldexp(1.0, -static_cast<int>(depth));
  const Verdict verdict = judge(piece, cover.size());
  if (verdict == Verdict::holds) {
    cover.push_back(static_cast<std::uint8_t>(depth));
    return std::nullopt;
  }
  if (verdict == Verdict::fails_at_begin) return Stop{begin, false};
  if (verdict == Verdict::fails_at_end) return Stop{begin + length, false};
  if (depth == kDeepest) return Stop{begin, true};
  const auto [left, right] = halves(piece);
  if (const auto stop = fill(left, depth + 1, begin, judge, cover)) return stop;
  return fill(right, depth + 1, begin + length / 2, judge, cover);
}

// --- obstacles ------------------------------------------------------------------------------

struct Box {
  Point low;
  Point high;
  std::size_t index = 0;
};

struct Interval {
  Whole low;
  Whole high;
};

Interval range(const std::vector<Point>& points, int axis) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

bool holds_point(const Box& box, const Point& p, unsigned shift) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.low[axis] << shift || p[axis] > box.high[axis] << shift) return false;
  }
  return true;
}

// A curve and the boxes that its bounding box meets.
struct Exposed {
  Curve curve;
  std::vector<const Box*> near;
};

Exposed exposed(Curve curve, const std::vector<const Box*>& boxes) {
  Exposed out{std::move(curve), {}};
  std::array<Interval, 3> r;
  for (int axis = 0; axis < 3; ++axis) r[axis] = range(out.curve.points, axis);
  const unsigned shift = out.curve.shift;
  for (const Box* box : boxes) {
    bool apart = false;
    for (int axis = 0; axis < 3 && !apart; ++axis) {
      apart = r[axis].high < box->low[axis] << shift || r[axis].low > box->high[axis] << shift;
    }
    if (!apart) out.near.push_back(box);
  }
  return out;
}

std::pair<Exposed, Exposed> halves(const Exposed& piece) {
  auto [left, right] = exact::halves(piece.curve);
  return {exposed(std::move(left), piece.near), exposed(std::move(right), piece.near)};
}

// A normal across an axis and the chord of a curve, and where the curve lies along it.
struct Direction {
  int axis;
  Whole j, k;  // components along the next two axes; the one along `axis` is 0
  Interval curve;

  Direction(const Curve& c, int along) : axis(along) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    j = c.points.front()[b] - c.points.back()[b];
    k = c.points.back()[a] - c.points.front()[a];
    for (const Point& p : c.points) {
      const Whole at = j * p[a] + k * p[b];
      if (&p == &c.points.front() || at < curve.low) curve.low = at;
      if (&p == &c.points.front() || at > curve.high) curve.high = at;
    }
  }

  // Whether the box is strictly on one side: +1 beyond the curve, -1 before it, 0 neither.
  int side(const Box& box, unsigned shift) const {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    const Whole low = j * (j > 0 ? box.low : box.high)[a] + k * (k > 0 ? box.low : box.high)[b];
    if (low << shift > curve.high) return 1;
    const Whole high = j * (j > 0 ? box.high : box.low)[a] + k * (k > 0 ? box.high : box.low)[b];
    if (high << shift < curve.low) return -1;
    return 0;
  }
};

class JudgeClear {
 public:
  explicit JudgeClear(std::vector<PieceAndPlane>& planes) : planes_(planes) {}
  std::optional<std::size_t> culprit;

  Verdict operator()(const Exposed& piece, std::size_t number) {
    if (piece.near.empty()) return Verdict::holds;
    const Curve& curve = piece.curve;
    for (const Box* box : piece.near) {
      culprit = box->index;
      if (holds_point(*box, curve.points.front(), curve.shift)) return Verdict::fails_at_begin;
      if (holds_point(*box, curve.points.back(), curve.shift)) return Verdict::fails_at_end;
    }
    const Direction directions[] = {{curve, 0}, {curve, 1}, {curve, 2}};
    const std::size_t before = planes_.size();
    for (const Box* box : piece.near) {
      if (separate(directions, *box, curve.shift, number)) continue;
      culprit = box->index;
      planes_.resize(before);
      return Verdict::unknown;
    }
    return Verdict::holds;
  }

 private:
  bool separate(std::span<const Direction> directions, const Box& box, unsigned shift,
                std::size_t number) {
    for (const Direction& d : directions) {
      const int side = d.side(box, shift);
      if (side) planes_.push_back({number, box.index, d.axis, side > 0});
      if (side) return true;
    }
    return false;
  }

  std::vector<PieceAndPlane>& planes_;
};

struct Inside {
  const Box& bounds;

  Verdict operator()(const Curve& curve, std::size_t) const {
    const auto in = [&](const Point& p) { return holds_point(bounds, p, curve.shift); };
    if (std::all_of(curve.points.begin(), curve.points.end(), in)) return Verdict::holds;
    if (!in(curve.points.front())) return Verdict::fails_at_begin;
    return in(curve.points.back()) ? Verdict::unknown : Verdict::fails_at_end;
  }
};

// --- limits ---------------------------------------------------------------------------------

// Polynomials that must all be >= 0.
struct Conditions {
  std::vector<Polynomial> all;
};

std::pair<Conditions, Conditions> halves(const Conditions& conditions) {
  std::pair<Conditions, Conditions> out;
  for (const Polynomial& q : conditions.all) {
    auto [left, right] = exact::halves(q);
    out.first.all.push_back(std::move(left));
    out.second.all.push_back(std::move(right));
  }
  return out;
}

Verdict not_negative(const Conditions& conditions, std::size_t) {
  bool holds = true;
  for (const Polynomial& q : conditions.all) {
    if (q.front() < 0) return Verdict::fails_at_begin;
    if (q.back() < 0) return Verdict::fails_at_end;
    holds = holds && std::all_of(q.begin(), q.end(), [](const Whole& c) { return c >= 0; });
  }
  return holds ? Verdict::holds : Verdict::unknown;
}

Whole choose(std::size_t n, std::size_t k) {
  Whole out;
  mpz_bin_uiui(out.get_mpz_t(), n, k);
  return out;
}

// A positive factor that makes the Bernstein coefficients of a product of two polynomials of degree
// n whole.
Whole common_factor(std::size_t n) {
  Whole out = 1;
  for (std::size_t k = 0; k <= 2 * n; ++k) out = lcm(out, choose(2 * n, k));
  return out;
}

// common_factor(n) times the square.
Polynomial squared(const Polynomial& p) {
  const std::size_t n = p.size() - 1;
  const Whole factor = common_factor(n);
  Polynomial out(2 * n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      out[i + j] += choose(n, i) * choose(n, j) * p[i] * p[j] * (factor / choose(2 * n, i + j));
    }
  }
  return out;
}

// The same sign with fewer digits.
void drop_zeros(Polynomial& p) {
  mp_bitcnt_t zeros = std::numeric_limits<mp_bitcnt_t>::max();
  for (const Whole& c : p) {
    if (c != 0) zeros = std::min(zeros, mpz_scan1(c.get_mpz_t(), 0));
  }
  for (Whole& c : p) {
    if (c != 0) c >>= zeros;
  }
}

// Coefficients along one axis of the derivative of that order, times duration^order, in 2^-1074.
Polynomial derivative(const Segment& s, int axis, int order) {
  Polynomial q;
  for (const Vec3& p : s.point) q.push_back(whole(p[axis]));
  for (int r = 0; r < order; ++r) {
    const unsigned degree = static_cast<unsigned>(q.size()) - 1;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) q[i] = degree * (q[i + 1] - q[i]);
    q.pop_back();
  }
  return q;
}

Whole power(const Whole& base, int exponent) {
  Whole out = 1;
  for (int i = 0; i < exponent; ++i) out *= base;
  return out;
}

// limit^2 - |derivative|^2, times duration^(2 order) and a power of two.
Conditions norm_condition(const Segment& s, int order, double limit) {
  const std::size_t n = static_cast<std::size_t>(kDegree - order);
  const Whole most = whole(limit) * power(whole(s.duration), order);
  Polynomial q(2 * n + 1, common_factor(n) * most * most);
  for (int axis = 0; axis < 3; ++axis) {
    const Polynomial square = squared(derivative(s, axis, order));
    for (std::size_t k = 0; k < q.size(); ++k) q[k] -= square[k] << (2 * order * exact::kUnit);
  }
  drop_zeros(q);
  return {{q}};
}

// A fraction <= tan(angle) within 2^-60 of it, by 2^64: the Taylor sums of sine up to the power 39
// (the last term negative) over cosine up to 40 (the last positive), rounded down.
Whole tangent_below(double angle) {
  const mpq_class x(angle);
  mpq_class term = 1;
  mpq_class sine = 0;
  mpq_class cosine = 0;
  for (int k = 0; k <= 40; ++k) {
    if (k) term *= x / k;
    const mpq_class signed_term = k % 4 < 2 ? term : mpq_class(-term);
    (k % 2 ? sine : cosine) += signed_term;
  }
  const mpq_class scaled = sine / cosine * mpq_class(Whole(1) << 64);
  return scaled.get_num() / scaled.get_den();
}

// The thrust a + g within a cone around up: its height z >= 0 and (z tan)^2 - x^2 - y^2 >= 0, both
// times powers of the duration and of two.
Conditions tilt_condition(const Segment& s, double limit) {
  Polynomial height = derivative(s, 2, 2);
  const Whole gravity = whole(kGravity) * power(whole(s.duration), 2);
  for (Whole& c : height) c = (c << (2 * exact::kUnit)) + gravity;
  Polynomial cone = squared(height);
  const Whole tangent = tangent_below(limit);
  for (Whole& c : cone) c *= tangent * tangent;
  for (int axis = 0; axis < 2; ++axis) {
    const Polynomial square = squared(derivative(s, axis, 2));
    for (std::size_t k = 0; k < cone.size(); ++k) cone[k] -= square[k] << (4 * exact::kUnit + 128);
  }
  drop_zeros(height);
  drop_zeros(cone);
  return {{height, cone}};
}

// --- joints ---------------------------------------------------------------------------------

// A derivative at the end or the beginning of a segment, in SI units.
std::array<mpq_class, 3> derivative_at(const Segment& s, int order, bool end) {
  std::array<mpq_class, 3> out;
  const mpq_class duration(s.duration);
  for (int axis = 0; axis < 3; ++axis) {
    const Polynomial q = derivative(s, axis, order);
    out[axis] = mpq_class(end ? q.back() : q.front(), Whole(1) << exact::kUnit);
    out[axis].canonicalize();
    for (int r = 0; r < order; ++r) out[axis] /= duration;
  }
  return out;
}

// --- the whole ------------------------------------------------------------------------------

class Proof {
 public:
  explicit Proof(const ExactTask& task) : task_(task) {
    const geom::Aabb& bounds = task.map.spec().bounds;
    bounds_ = {whole(bounds.min), whole(bounds.max), 0};
    for (int axis = 0; axis < 3; ++axis) {
      grown_by_[axis] = whole(task.vehicle.half[axis]) + whole(task.margin);
      bounds_.low[axis] += grown_by_[axis];
      bounds_.high[axis] -= grown_by_[axis];
    }
  }

  ExactResult of(const Trajectory& trajectory) {
    if (!durations_are_sound(trajectory)) return result_;
    const auto& segments = trajectory.segments;
    result_.segments.resize(segments.size());
    double t = 0;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
      t += segments[i].duration;
      if (!joint(segments[i], segments[i + 1], t)) return result_;
    }
    const auto each = [&](const auto& step) {
      double begin = 0;
      for (std::size_t i = 0; i < segments.size(); begin += segments[i++].duration) {
        const Timing timing{begin, segments[i].duration};
        if (!step(segments[i], timing, result_.segments[i])) return false;
      }
      return true;
    };
    const Limits& limits = task_.limits;
    const auto limited = [&](const char* reason, const std::optional<double>& limit, int order,
                             Cover SegmentProof::*cover) {
      return !limit || each([&](const Segment& s, Timing timing, SegmentProof& proof) {
        return within(s, norm_condition(s, order, *limit), timing, reason, proof.*cover);
      });
    };
    result_.ok = each([&](const Segment& s, Timing timing, SegmentProof& proof) {
                   return inside(s.point, timing, proof.bounds);
                 }) &&
                 each([&](const Segment& s, Timing timing, SegmentProof& proof) {
                   return clear(s.point, timing, proof.clear);
                 }) &&
                 gaps(trajectory) && limited("speed", limits.vmax, 1, &SegmentProof::speed) &&
                 limited("acceleration", limits.amax, 2, &SegmentProof::acceleration) &&
                 limited("jerk", limits.jmax, 3, &SegmentProof::jerk) &&
                 (!limits.tilt || each([&](const Segment& s, Timing timing, SegmentProof& proof) {
                   return within(s, tilt_condition(s, *limits.tilt), timing, "tilt", proof.tilt);
                 }));
    return result_;
  }

  ExactResult of(std::span<const Vec3> points) {
    if (points.empty()) result_.reason = "no_path";
    if (points.empty()) return result_;
    const std::size_t legs = std::max<std::size_t>(points.size() - 1, 1);
    result_.segments.resize(legs);
    const auto leg = [&](std::size_t i) {
      return std::array{points[i], points[std::min(i + 1, points.size() - 1)]};
    };
    for (std::size_t i = 0; i < legs; ++i) {
      const Timing timing{static_cast<double>(i), 1};
      if (!inside(leg(i), timing, result_.segments[i].bounds)) return result_;
    }
    for (std::size_t i = 0; i < legs; ++i) {
      const Timing timing{static_cast<double>(i), 1};
      if (!clear(leg(i), timing, result_.segments[i].clear)) return result_;
    }
    result_.ok = true;
    return result_;
  }

 private:
  struct Timing {
    double begin;
    double duration;
  };

  static Curve curve_through(std::span<const Vec3> points) {
    Curve curve;
    for (const Vec3& p : points) curve.points.push_back(whole(p));
    return curve;
  }

  bool refuse(const char* reason, double time, const Vec3& place) {
    result_.reason = reason;
    result_.time = time;
    result_.place = place;
    return false;
  }

  // Of a curve of any degree: de Casteljau in doubles, for the report only.
  static Vec3 place_at(std::vector<Vec3> q, double part) {
    for (; q.size() > 1; q.pop_back()) {
      for (std::size_t i = 0; i + 1 < q.size(); ++i) q[i] += part * (q[i + 1] - q[i]);
    }
    return q[0];
  }

  bool refuse(const char* reason, const Stop& stop, Timing timing, std::span<const Vec3> points) {
    result_.undecided = stop.undecided;
    return refuse(reason, timing.begin + stop.part * timing.duration,
                  place_at({points.begin(), points.end()}, stop.part));
  }

  bool durations_are_sound(const Trajectory& trajectory) {
    double t = 0;
    for (const Segment& s : trajectory.segments) {
      bool sound = std::isfinite(s.duration) && s.duration > 0;
      for (const Vec3& p : s.point) sound = sound && p.allFinite();
      if (!sound) return refuse("duration", t, Vec3::Zero());
      t += s.duration;
    }
    if (trajectory.segments.empty()) return refuse("duration", 0, Vec3::Zero());
    return true;
  }

  bool joint(const Segment& before, const Segment& after, double time) {
    const double most[] = {1e-9, 1e-6, 1e-4};  // CheckOptions
    bool ok = true;
    for (int order = 0; order < 4; ++order) {
      const auto a = derivative_at(before, order, true);
      const auto b = derivative_at(after, order, false);
      mpq_class square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const mpq_class step = b[axis] - a[axis];
        square += step * step;
        worst_[order] = std::max(worst_[order], mpq_class(abs(step)));
      }
      result_.joints[order] = worst_[order].get_str();
      if (order == 3) continue;
      const mpq_class limit = mpq_class(most[order]) * mpq_class(1001, 1000);
      ok = ok && square <= limit * limit;
    }
    return ok || refuse("discontinuous", time, before.point[kDegree]);
  }

  // The boxes that may meet the bounding box of the points. In doubles, with room for rounding:
  // coordinates are within 1e8 m (geom::kLargestCoordinate), where doubles are 1.5e-8 m apart.
  std::vector<Box> boxes_around(std::span<const Vec3> points) const {
    const geom::Aabb around = *geom::bounds(points);
    const Vec3 reach = task_.vehicle.half.array() + (task_.margin + 1e-6);
    std::vector<Box> out;
    const auto boxes = task_.map.boxes();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto& box = boxes[i];
      if (!geom::overlap({box.min - reach, box.max + reach}, around)) continue;
      Box grown{whole(box.min), whole(box.max), i};
      for (int axis = 0; axis < 3; ++axis) {
        grown.low[axis] -= grown_by_[axis];
        grown.high[axis] += grown_by_[axis];
      }
      out.push_back(std::move(grown));
    }
    return out;
  }

  bool clear(std::span<const Vec3> points, Timing timing, ClearCover& cover) {
    const std::vector<Box> boxes = boxes_around(points);
    std::vector<const Box*> near;
    for (const Box& box : boxes) near.push_back(&box);
    JudgeClear judge(cover.planes);
    auto stop = fill(exposed(curve_through(points), near), 0, 0, judge, cover.pieces);
    if (!stop) return true;
    result_.box = judge.culprit;
    // The planes of a straight piece leave nothing out: halving it only looks for the place.
    const bool straight = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return p == points.front() || p == points.back();
    });
    if (straight) stop->undecided = false;
    return refuse("collision", *stop, timing, points);
  }

  bool gaps(const Trajectory& trajectory) {
    double t = 0;
    for (std::size_t i = 0; i + 1 < trajectory.segments.size(); ++i) {
      const Segment& s = trajectory.segments[i];
      t += s.duration;
      const std::array ends{s.point[kDegree], trajectory.segments[i + 1].point[0]};
      if (ends[0] == ends[1]) continue;
      if (!clear(ends, {t, 0}, result_.segments[i].gap.emplace())) return false;
    }
    return true;
  }

  bool inside(std::span<const Vec3> points, Timing timing, Cover& cover) {
    Inside judge{bounds_};
    const auto stop = fill(curve_through(points), 0, 0, judge, cover);
    return !stop || refuse("bounds", *stop, timing, points);
  }

  bool within(const Segment& s, const Conditions& conditions, Timing timing, const char* reason,
              Cover& cover) {
    auto judge = not_negative;
    const auto stop = fill(conditions, 0, 0, judge, cover);
    return !stop || refuse(reason, *stop, timing, s.point);
  }

  const ExactTask& task_;
  Point grown_by_;
  Box bounds_;
  std::array<mpq_class, 4> worst_;
  ExactResult result_;
};

}  // namespace

ExactResult check_exactly(const ExactTask& task, const Trajectory& trajectory) {
  return Proof(task).of(trajectory);
}

ExactResult check_exactly(const ExactTask& task, std::span<const Vec3> points) {
  return Proof(task).of(points);
}

}  // namespace traj
