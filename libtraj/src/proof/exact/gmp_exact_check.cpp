#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxes_near.h"
#include "geom/base/error.h"
#include "geom/record/flight_time.h"
#include "gmp_conditions.h"
#include "gmp_judge.h"
#include "traj/proof/check.h"
#include "traj/proof/domain.h"
#include "traj/proof/exact/exact_check.h"

namespace traj {
namespace {

using exact::Box;
using exact::Conditions;
using exact::Curve;
using exact::Point;
using exact::Polynomial;
using exact::Verdict;
using exact::Whole;
using exact::whole;

constexpr unsigned kDeepest = 60;  // halvings, as deep as the fast check goes

// Where a cover stopped.
struct Stop {
  double part = 0;  // of the curve
  bool undecided = false;
};

struct Part {
  unsigned depth = 0;  // halvings
  double begin = 0;    // share of the curve
};

// Halves `piece` until judge(piece, cover) holds on every part and fills the cover; stops at the
// first part where it does not.
template <class Piece, class Judge>
std::optional<Stop> fill(const Piece& piece, const Part& part, Judge& judge, Cover& cover) {
  const auto& [depth, begin] = part;
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
  if (const auto stop = fill(left, Part{depth + 1, begin}, judge, cover)) return stop;
  return fill(right, Part{depth + 1, begin + length / 2}, judge, cover);
}

// n times 2^-1074, canonical: without the common power of 2 nothing is left to divide by.
mpq_class in_units(const Whole& n) {
  if (n == 0) return 0;
  const mp_bitcnt_t zeros = std::min<mp_bitcnt_t>(mpz_scan1(n.get_mpz_t(), 0), exact::kUnit);
  return {Whole(n >> zeros), Whole(1) << (exact::kUnit - zeros)};
}

// A derivative at the end or the beginning of a segment, in SI units.
std::array<mpq_class, 3> derivative_at(const Segment& s, int order, bool end) {
  std::array<mpq_class, 3> out;
  const mpq_class duration(s.duration);
  for (int axis = 0; axis < 3; ++axis) {
    const Polynomial q = exact::derivative(s, axis, order);
    out[axis] = in_units(end ? q.back() : q.front());
    for (int r = 0; r < order; ++r) out[axis] /= duration;
  }
  return out;
}

// That a segment keeps a limit of `most`.
Conditions condition(const Segment& s, Limit limit, double most) {
  constexpr std::array kAll{0, 1, 2};
  constexpr std::array kLevel{0, 1};
  constexpr std::array kUpright{2};
  switch (limit) {
    case Limit::speed:
      return exact::norm_condition(s, 1, most, kAll);
    case Limit::horizontal_speed:
      return exact::norm_condition(s, 1, most, kLevel);
    case Limit::vertical_speed:
      return exact::norm_condition(s, 1, most, kUpright);
    case Limit::acceleration:
      return exact::norm_condition(s, 2, most, kAll);
    case Limit::jerk:
      return exact::norm_condition(s, 3, most, kAll);
    case Limit::tilt:
      return exact::tilt_condition(s, exact::tangent_below(most));
    case Limit::thrust:
      return exact::thrust_condition(s, most);
    case Limit::body_rate:
      return exact::body_rate_condition(s, most);
    case Limit::yaw_rate:
      return exact::yaw_rate_condition(s, most);
  }
  throw std::logic_error("no such limit");
}

// All steps in the order of their reasons; each returns false once it has refused.
class Proof {
 public:
  explicit Proof(const ExactTask& task) : task_(task) {
    if (task.start && !(std::abs(*task.start) <= geom::kLargestTime)) {
      throw geom::InputError("start",
                             {.expected = fmt::format("seconds within {:g}", geom::kLargestTime),
                              .found = fmt::to_string(*task.start)});
    }
    if (!has_sound_vehicle()) return;
    const geom::Aabb& bounds = task.map.spec().bounds;
    bounds_ = {whole(bounds.min), whole(bounds.max), 0};
    for (int axis = 0; axis < 3; ++axis) {
      grown_by_[axis] = whole(task.vehicle.half[axis]) + whole(task.margin);
      bounds_.low[axis] += grown_by_[axis];
      bounds_.high[axis] -= grown_by_[axis];
    }
  }

  ExactResult of(const Trajectory& trajectory) {
    if (!has_sound_vehicle()) return result_;
    if (const auto outside = outside_domain(trajectory, task_.limits)) {
      refuse(outside->reason, outside->time, Vec3::Zero());
      return result_;
    }
    const auto& segments = trajectory.segments;
    result_.segments.resize(segments.size());
    double t = 0;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
      t += segments[i].duration;
      if (!joint(segments[i], segments[i + 1], t)) return result_;
    }
    const auto each = [&](const auto& step) {
      Timing timing{0, 0, start(), {}};
      for (std::size_t i = 0; i < segments.size(); ++i) {
        timing.duration = segments[i].duration;
        timing.to = timing.from + whole(timing.duration);
        if (!step(segments[i], timing, result_.segments[i])) return false;
        timing.begin += timing.duration;
        timing.from = timing.to;
      }
      return true;
    };
    const Limits& limits = task_.limits;
    const Whole tangent = limits[Limit::tilt] ? exact::tangent_below(*limits[Limit::tilt]) : 0;
    const auto holds = [&](Limit limit) {
      return !limits[limit] || each([&](const Segment& s, Timing timing, SegmentProof& proof) {
        if (limit == Limit::yaw_rate && !s.yaw) return true;
        const Conditions conditions = limit == Limit::tilt ? exact::tilt_condition(s, tangent)
                                                           : condition(s, limit, *limits[limit]);
        return within(s, conditions, timing, broken(limit), proof.limits[limit]);
      });
    };
    const auto yaw_is_whole = [&] {
      const auto gap = limits[Limit::yaw_rate] ? gap_in_yaw(trajectory) : std::nullopt;
      return !gap || refuse(unmeasured(Limit::yaw_rate), 0, segments[*gap].point.front());
    };
    const auto is_inside = [&](const Segment& s, Timing timing, SegmentProof& proof) {
      return inside(s.point, timing, proof.bounds);
    };
    const auto is_clear = [&](const Segment& s, Timing timing, SegmentProof& proof) {
      const auto segment = static_cast<std::size_t>(&s - segments.data());
      return clear(2 * segment, s.point, timing, proof.clear);
    };
    if (!each(is_inside)) return result_;
    look_around(trajectory);
    result_.ok = each(is_clear) && gaps(trajectory) && stands(trajectory) &&
                 std::all_of(kOrderOfLimits.begin(), kOrderOfLimits.end(), holds) && yaw_is_whole();
    return result_;
  }

  ExactResult of(std::span<const Vec3> points) {
    if (points.empty()) {
      result_.reason = Reason::no_path;
      return result_;
    }
    if (!has_sound_vehicle()) return result_;
    if (const auto outside = outside_domain(points)) {
      refuse(outside->reason, outside->time, Vec3::Zero());
      return result_;
    }
    const std::size_t legs = std::max<std::size_t>(points.size() - 1, 1);
    result_.segments.resize(legs);
    const auto leg = [&](std::size_t i) {
      return std::array{points[i], points[std::min(i + 1, points.size() - 1)]};
    };
    for (std::size_t i = 0; i < legs; ++i) {
      const Timing timing{.begin = static_cast<double>(i), .duration = 1};
      if (!inside(leg(i), timing, result_.segments[i].bounds)) return result_;
    }
    std::vector<geom::Aabb> curves;
    for (std::size_t i = 0; i < legs; ++i) curves.push_back(around(leg(i)));
    look_around(curves);
    for (std::size_t i = 0; i < legs; ++i) {
      const Timing timing{.begin = static_cast<double>(i), .duration = 1};
      if (!clear(i, leg(i), timing, result_.segments[i].clear)) return result_;
    }
    result_.ok = true;
    return result_;
  }

 private:
  struct Timing {
    double begin;  // rounded, for reports
    double duration;
    Whole from = {};  // seconds after the epoch in 2^-1074, where times count
    Whole to = {};
  };

  Whole start() const { return whole(task_.start.value_or(0)); }

  static Curve curve_through(std::span<const Vec3> points) {
    Curve curve;
    for (const Vec3& p : points) curve.points.push_back(whole(p));
    return curve;
  }

  bool refuse(Reason reason, double time, const Vec3& place) {
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

  bool refuse(Reason reason, const Stop& stop, Timing timing, std::span<const Vec3> points) {
    result_.undecided = stop.undecided;
    return refuse(reason, timing.begin + stop.part * timing.duration,
                  place_at({points.begin(), points.end()}, stop.part));
  }

  // Half sizes and margin that the boxes around a curve are looked for by.
  bool has_sound_vehicle() {
    const auto sound = [](double size) { return size >= 0 && size <= geom::kLargestCoordinate; };
    const Vec3& half = task_.vehicle.half;
    return (std::all_of(half.begin(), half.end(), sound) && sound(task_.margin)) ||
           refuse(Reason::vehicle, 0, Vec3::Zero());
  }

  bool joint(const Segment& before, const Segment& after, double time) {
    const double most[] = {1e-9, 1e-6, 1e-4};  // CheckOptions
    const mpq_class share = share_of(before, after);
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
      for (const Limit next : kNext[order]) {
        if (!task_.limits[next]) continue;
        const mpq_class step = share * mpq_class(*task_.limits[next]);
        ok = ok && square <= step * step * (next == Limit::body_rate ? square_of_force(a) : 1);
      }
    }
    ok = ok && yaw_joins(before, after, share);
    return ok || refuse(Reason::discontinuous, time, before.point[kDegree]);
  }

  // The limits on the next derivative of the position, the velocity and the acceleration.
  static constexpr std::array<std::array<Limit, 3>, 3> kNext{
      {{Limit::speed, Limit::horizontal_speed, Limit::vertical_speed},
       {Limit::acceleration, Limit::acceleration, Limit::acceleration},
       {Limit::jerk, Limit::body_rate, Limit::body_rate}}};

  // Of these limits, which the steps at a joint may be (CheckOptions::step_share), times seconds.
  static mpq_class share_of(const Segment& before, const Segment& after) {
    return mpq_class(kStepShare) * mpq_class(1001, 1000) *
           mpq_class(std::min(before.duration, after.duration));
  }

  template <class Vector>
  static mpq_class square_of_force(const Vector& acceleration) {
    const mpq_class up = acceleration[2] + mpq_class(kGravity);
    return acceleration[0] * acceleration[0] + acceleration[1] * acceleration[1] + up * up;
  }

  bool yaw_joins(const Segment& before, const Segment& after, const mpq_class& share) const {
    if (!before.yaw || !after.yaw) return true;
    const auto& a = *before.yaw;
    const auto& b = *after.yaw;
    const auto exact_step = [](double from, double to) -> mpq_class {
      return mpq_class(to) - mpq_class(from);
    };
    const mpq_class rate_step =
        kDegree * exact_step(b[0], b[1]) / mpq_class(after.duration) -
        kDegree * exact_step(a[kDegree - 1], a[kDegree]) / mpq_class(before.duration);
    const mpq_class more(1001, 1000);
    const mpq_class step = abs(exact_step(a[kDegree], b[0]));
    const auto& rate = task_.limits[Limit::yaw_rate];
    return step <= mpq_class(1e-9) * more && (!rate || step <= share * mpq_class(*rate)) &&
           abs(rate_step) <= mpq_class(1e-6) * more;
  }

  // The boxes that may meet the bounding box of each of the curves, in their order. In doubles,
  // with room for rounding: coordinates are within 1e8 m (geom::kLargestCoordinate), where doubles
  // are 1.5e-8 m apart.
  void look_around(std::span<const geom::Aabb> curves) {
    const Vec3 reach = task_.vehicle.half.array() + (task_.margin + 1e-6);
    near_ = exact::boxes_near(task_.map.boxes(), reach, curves);
  }

  static geom::Aabb around(std::span<const Vec3> points) { return *geom::bounds(points); }

  // Of each segment, and of what may lie between it and the next.
  void look_around(const Trajectory& trajectory) {
    const auto& segments = trajectory.segments;
    std::vector<geom::Aabb> curves;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      curves.push_back(around(segments[i].point));
      if (i + 1 == segments.size()) break;
      curves.push_back(around(std::array{segments[i].point[kDegree], segments[i + 1].point[0]}));
    }
    look_around(curves);
  }

  Box grown(std::size_t i) const {
    const geom::Aabb& box = task_.map.boxes()[i];
    Box out{whole(box.min), whole(box.max), i};
    for (int axis = 0; axis < 3; ++axis) {
      out.low[axis] -= grown_by_[axis];
      out.high[axis] += grown_by_[axis];
    }
    if (!task_.start) return out;
    const geom::TimeSpan time = task_.map.time(i);
    if (std::isfinite(time.from)) out.from = whole(time.from);
    if (std::isfinite(time.until)) out.until = whole(time.until);
    return out;
  }

  // `curve`: as look_around() counts.
  bool clear(std::size_t curve, std::span<const Vec3> points, Timing timing, ClearCover& cover) {
    std::vector<Box> boxes;
    for (const std::size_t i : near_[curve]) boxes.push_back(grown(i));
    std::vector<const Box*> near;
    for (const Box& box : boxes) near.push_back(&box);
    exact::JudgeClear judge(cover.planes);
    auto stop = fill(exact::exposed(curve_through(points), near, {timing.from, timing.to}), {},
                     judge, cover.pieces);
    if (!stop) return true;
    result_.box = judge.culprit;
    // The planes of a straight piece leave nothing out: halving it only looks for the place.
    const bool straight = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return p == points.front() || p == points.back();
    });
    if (straight && !task_.start) stop->undecided = false;
    return refuse(Reason::collision, *stop, timing, points);
  }

  // Each box is apart in place or time from the first point before the begin, and from the last one
  // after the end.
  bool stands(const Trajectory& trajectory) {
    if (!task_.start || !task_.stands) return true;
    const Vec3& first = trajectory.segments.front().point[0];
    const Vec3& last = trajectory.segments.back().point[kDegree];
    const Whole begin = start();
    Whole end = begin;
    for (const Segment& s : trajectory.segments) end += whole(s.duration);
    for (const std::size_t i : task_.map.timed()) {
      const Box box = grown(i);
      result_.box = i;
      if (!(box.from && *box.from > begin) && exact::holds_point(box, whole(first), 0)) {
        return refuse(Reason::collision, 0, first);
      }
      if (!(box.until && *box.until < end) && exact::holds_point(box, whole(last), 0)) {
        return refuse(Reason::collision, duration(trajectory), last);
      }
    }
    result_.box.reset();
    return true;
  }

  bool gaps(const Trajectory& trajectory) {
    double t = 0;
    Whole instant = start();
    for (std::size_t i = 0; i + 1 < trajectory.segments.size(); ++i) {
      const Segment& s = trajectory.segments[i];
      t += s.duration;
      instant += whole(s.duration);
      const std::array ends{s.point[kDegree], trajectory.segments[i + 1].point[0]};
      if (ends[0] == ends[1]) continue;
      if (!clear(2 * i + 1, ends, {t, 0, instant, instant}, result_.segments[i].gap.emplace()))
        return false;
    }
    return true;
  }

  bool inside(std::span<const Vec3> points, Timing timing, Cover& cover) {
    exact::JudgeInside judge{bounds_};
    const auto stop = fill(curve_through(points), {}, judge, cover);
    return !stop || refuse(Reason::bounds, *stop, timing, points);
  }

  bool within(const Segment& s, const Conditions& conditions, Timing timing, Reason reason,
              Cover& cover) {
    auto judge = exact::not_negative;
    const auto stop = fill(conditions, {}, judge, cover);
    return !stop || refuse(reason, *stop, timing, s.point);
  }

  const ExactTask& task_;
  Point grown_by_;
  Box bounds_;
  std::array<mpq_class, 4> worst_;
  std::vector<std::vector<std::size_t>> near_;  // boxes, of each curve
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
