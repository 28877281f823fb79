#include "traj/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "check_limits.h"
#include "check_place.h"
#include "curve_piece.h"
#include "geom/error.h"
#include "geom/precondition.h"
#include "least_clearance.h"
#include "traj/continuity.h"

namespace traj {
namespace {

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

// Differences and squares of such points overflow.
bool is_within_reach(const Trajectory& trajectory, CheckResult& result) {
  double begin = 0;
  for (const Segment& s : trajectory.segments) {
    for (const Vec3& p : s.point) {
      if (p.cwiseAbs().maxCoeff() <= geom::kFarthest) continue;
      note(result, "bounds", {p.cwiseAbs().maxCoeff(), begin, p});
      return false;
    }
    begin += s.duration;
  }
  return true;
}

// A comparison with what is not a number holds whatever it is compared with.
void require_numbers(const CheckOptions& options) {
  const auto require = [](const char* what, double value) {
    if (value >= 0) return;
    throw geom::InputError(what, fmt::format("expected a number >= 0, found {}", value));
  };
  for (const LimitField& field : kLimitFields) {
    if (options.limits.*field.member) require(field.name, *(options.limits.*field.member));
  }
  require("limit_slack", options.limit_slack);
  require("position_gap", options.position_gap);
  require("velocity_gap", options.velocity_gap);
  require("acceleration_gap", options.acceleration_gap);
  require("yaw_gap", options.yaw_gap);
  require("yaw_rate_gap", options.yaw_rate_gap);
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
    if (!(gap <= options.position_gap)) {
      note(result, "discontinuous", {gap, t, s.point[kDegree]});
    } else if (const double dv = (b.velocity - a.velocity).norm(); !(dv <= options.velocity_gap)) {
      note(result, "discontinuous", {dv, t, s.point[kDegree]});
    } else if (const double da = (b.acceleration - a.acceleration).norm();
               !(da <= options.acceleration_gap)) {
      note(result, "discontinuous", {da, t, s.point[kDegree]});
    } else if (const double dy = yaw_jump(s, next, 0); !(dy <= options.yaw_gap)) {
      note(result, "discontinuous", {dy, t, s.point[kDegree]});
    } else if (const double dr = yaw_jump(s, next, 1); !(dr <= options.yaw_rate_gap)) {
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
  require_numbers(options);
  CheckResult result;
  if (!durations_are_sound(trajectory, result) || !is_within_reach(trajectory, result)) {
    return result;
  }
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
  for (const Vec3& p : points) geom::require_point("path", p);
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
