#include "traj/proof/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "check_limits.h"
#include "check_place.h"
#include "curve/continuity.h"
#include "curve/curve_piece.h"
#include "geom/base/error.h"
#include "geom/record/flight_time.h"
#include "least_clearance.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

// A comparison with what is not a number holds whatever it is compared with.
void require_numbers(const CheckOptions& options, std::size_t segments) {
  const auto require = [](const char* what, double value) {
    if (value >= 0) return;
    throw geom::InputError(what, {.expected = "a number >= 0", .found = fmt::to_string(value)});
  };
  require("limit_slack", options.limit_slack);
  require("position_gap", options.position_gap);
  require("velocity_gap", options.velocity_gap);
  require("acceleration_gap", options.acceleration_gap);
  require("yaw_gap", options.yaw_gap);
  require("yaw_rate_gap", options.yaw_rate_gap);
  require("step_share", options.step_share);
  if (!options.stray.empty() && options.stray.size() != segments) {
    throw geom::InputError("stray",
                           {.expected = fmt::format("one for each of {} segments", segments),
                            .found = fmt::to_string(options.stray.size())});
  }
  for (const Stray& stray : options.stray) {
    for (const double along : stray.position) require("stray.position", along);
    require("stray.velocity", stray.velocity);
    require("stray.acceleration", stray.acceleration);
    require("stray.jerk", stray.jerk);
    require("stray.yaw_rate", stray.yaw_rate);
  }
  if (options.start && !(std::abs(*options.start) <= geom::kLargestTime)) {
    throw geom::InputError("start",
                           {.expected = fmt::format("seconds within {:g}", geom::kLargestTime),
                            .found = fmt::to_string(*options.start)});
  }
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

// The largest steps that a joint may have.
class Steps {
 public:
  Steps(const CheckOptions& options, double seconds, const Vec3& acceleration) {
    const Limits& limits = options.limits;
    const double share = options.step_share * seconds;
    const double force = (acceleration + kGravity * Vec3::UnitZ()).norm();
    const auto lower = [&](double& step, Limit limit, double unit) {
      if (limits[limit]) step = std::min(step, share * *limits[limit] * unit);
    };
    position = options.position_gap;
    for (const Limit speed : {Limit::speed, Limit::horizontal_speed, Limit::vertical_speed}) {
      lower(position, speed, 1);
    }
    velocity = options.velocity_gap;
    lower(velocity, Limit::acceleration, 1);
    change = options.acceleration_gap;
    lower(change, Limit::jerk, 1);
    lower(change, Limit::body_rate, force);
    yaw = options.yaw_gap;
    lower(yaw, Limit::yaw_rate, 1);
  }

  double position;
  double velocity;
  double change;  // of the acceleration
  double yaw;
};

void check_joints(const Trajectory& trajectory, const CheckOptions& options, CheckResult& result) {
  double t = 0;
  for (std::size_t i = 0; i + 1 < trajectory.segments.size(); ++i) {
    const Segment& s = trajectory.segments[i];
    const Segment& next = trajectory.segments[i + 1];
    t += s.duration;
    const State a = evaluate(s, s.duration);
    const State b = evaluate(next, 0);
    const double gap = (next.point[0] - s.point[kDegree]).norm();
    const Steps most(options, std::min(s.duration, next.duration), a.acceleration);
    // Written so that what is not a number is refused.
    if (!(gap <= most.position)) {
      note(result, Reason::discontinuous, {gap, t, s.point[kDegree]});
    } else if (const double dv = (b.velocity - a.velocity).norm(); !(dv <= most.velocity)) {
      note(result, Reason::discontinuous, {dv, t, s.point[kDegree]});
    } else if (const double da = (b.acceleration - a.acceleration).norm(); !(da <= most.change)) {
      note(result, Reason::discontinuous, {da, t, s.point[kDegree]});
    } else if (const double dy = yaw_jump(s, next, 0); !(dy <= most.yaw)) {
      note(result, Reason::discontinuous, {dy, t, s.point[kDegree]});
    } else if (const double dr = yaw_jump(s, next, 1); !(dr <= options.yaw_rate_gap)) {
      note(result, Reason::discontinuous, {dr, t, s.point[kDegree]});
    } else {
      continue;
    }
    return;
  }
}

// The segments with what may be beside them, and where neighbours miss each other, the steps.
std::vector<Piece> pieces_and_steps(const Trajectory& trajectory, std::span<const Stray> stray) {
  std::vector<Piece> pieces = pieces_of(trajectory);
  const std::size_t count = pieces.size();
  for (std::size_t i = 0; i < stray.size(); ++i) pieces[i].stray = stray[i].position;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Vec3& a = pieces[i].q[kDegree];
    const Vec3& b = pieces[i + 1].q[0];
    if (a == b) continue;
    const Vec3 both = pieces[i].stray.cwiseMax(pieces[i + 1].stray);
    pieces.push_back({{a, a, a, a, b, b, b, b}, pieces[i].end, pieces[i].end, both});
  }
  return pieces;
}

// The pieces, and where it stands before `first` and after `last`.
std::vector<Piece> with_stands(std::vector<Piece> pieces, const Piece& first, const Piece& last) {
  const auto stand = [&](const Vec3& p, double begin, double end, const Vec3& stray) {
    pieces.push_back({{p, p, p, p, p, p, p, p}, begin, end, stray});
  };
  stand(first.q[0], -kEver, first.begin, first.stray);
  stand(last.q[kDegree], last.end, kEver, last.stray);
  return pieces;
}

}  // namespace

CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const CheckOptions& options) {
  require_numbers(options, trajectory.segments.size());
  CheckResult result;
  if (const auto outside = outside_domain(trajectory, options.limits)) {
    note(result, outside->reason, {outside->value, outside->time, Vec3::Zero()});
    return result;
  }
  result.looked = true;
  result.duration = duration(trajectory);
  const std::vector<Piece> pieces = pieces_and_steps(trajectory, options.stray);
  const BoxTimes times(scene.map(), options.start, pieces.size(), result.duration);
  check_joints(trajectory, options, result);
  if (result.reason == Reason::none && options.stands && times.count()) {
    const Piece& last = pieces[trajectory.segments.size() - 1];
    check_place(scene, times, with_stands(pieces, pieces.front(), last), result);
  } else if (result.reason == Reason::none) {
    check_place(scene, times, pieces, result);
  }
  check_limits(trajectory, options, result);
  result.jumps = largest_jumps(trajectory);
  if (options.clearance == Clearance::measured)
    result.clearance = least_clearance(scene, times, pieces);
  result.ok = result.reason == Reason::none;
  return result;
}

CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const Limits& limits) {
  CheckOptions options;
  options.limits = limits;
  return check(scene, trajectory, options);
}

CheckResult check_path(const geom::CollisionScene& scene, std::span<const Vec3> points,
                       std::span<const Vec3> stray, Clearance clearance) {
  CheckResult result;
  if (const auto outside = outside_domain(points)) {
    note(result, outside->reason, {outside->value, outside->time, Vec3::Zero()});
    return result;
  }
  std::vector<Piece> pieces;
  std::vector<Leg> legs;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    const std::size_t i = pieces.size();
    const auto index = static_cast<double>(i);
    const Vec3 beside = stray.empty() ? Vec3(Vec3::Zero()) : stray[i];
    pieces.push_back({{a, a, a, a, b, b, b, b}, index, index + 1, beside});  // exact without it
    legs.push_back({a, b, index, index + 1, beside});
  };
  for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
  if (points.size() == 1) add(points[0], points[0]);
  if (pieces.empty()) {
    result.reason = Reason::no_path;
    return result;
  }
  result.looked = true;
  check_place(scene, BoxTimes(), pieces, result);
  if (clearance == Clearance::measured) result.clearance = least_clearance(scene, legs);
  result.ok = result.reason == Reason::none;
  return result;
}

std::vector<Limit> not_measured(const CheckResult& result, const Limits& limits) {
  std::vector<Limit> missing;
  for (const Limit limit : kOrderOfLimits) {
    if (limits[limit] && !result.largest[limit]) missing.push_back(limit);
  }
  return missing;
}

}  // namespace traj
