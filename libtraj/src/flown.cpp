#include "traj/flown.h"

#include <algorithm>
#include <cmath>

#include "portable_math.h"

namespace traj {
namespace {

constexpr double kStanding = 1e-3;  // m: what stands touches, so the check begins above
constexpr double kSlack = 1e-3;     // relative, on limits

void refuse(CheckResult& result, std::string_view reason, double time, const Vec3& place,
            double worst) {
  if (!result.reason.empty()) return;
  result.ok = false;
  result.reason = reason;
  result.time = time;
  result.place = place;
  result.worst = worst;
}

// --- setpoints ------------------------------------------------------------------------------

double across(const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

void check_setpoint(const Setpoint& s, const Limits& limits, CheckResult& result) {
  const Vec3& v = s.state.velocity;
  const Vec3 f = s.state.acceleration + Vec3(0, 0, kGravity);
  const auto hold = [&](const std::optional<double>& limit, std::string_view reason, double value,
                        Extreme& extreme) {
    if (value > extreme.value) extreme = {value, s.time};
    if (limit && value > *limit * (1 + kSlack)) {
      refuse(result, reason, s.time, s.state.position, value);
    }
  };
  hold(limits.vmax, "speed", v.norm(), result.speed);
  hold(limits.amax, "acceleration", s.state.acceleration.norm(), result.acceleration);
  const double tilt = f.isZero(0) ? kPi : angle_of(f.z(), across(f));
  hold(limits.tilt, "tilt", tilt, result.tilt);
  hold(limits.vmax_h, "horizontal_speed", across(v), result.horizontal_speed);
  hold(limits.vmax_v, "vertical_speed", std::abs(v.z()), result.vertical_speed);
  hold(limits.thrust, "thrust", f.norm(), result.thrust);
  hold(limits.yaw_rate, "yaw_rate", std::abs(s.yaw_rate), result.yaw_rate);
}

// The time at a leg's index and the part of it.
double time_at(const std::vector<Setpoint>& setpoints, double leg) {
  const auto i = std::min(static_cast<std::size_t>(leg), setpoints.size() - 2);
  const double begin = setpoints[i].time;
  return begin + (leg - static_cast<double>(i)) * (setpoints[i + 1].time - begin);
}

CheckResult check_setpoints(const geom::CollisionScene& scene, const Flown& flown,
                            const Limits& limits) {
  const auto& setpoints = flown.setpoints;
  geom::Polyline way;
  for (const Setpoint& s : setpoints) way.push_back(s.state.position);
  CheckResult result = check_path(scene, way);
  result.time = time_at(setpoints, result.time);
  if (result.clearance) result.clearance->time = time_at(setpoints, result.clearance->time);
  result.duration = setpoints.back().time - setpoints.front().time;
  for (const Setpoint& s : setpoints) check_setpoint(s, limits, result);
  return result;
}

// --- paths ----------------------------------------------------------------------------------

void check_legs(const geom::Polyline& way, double speed, const Limits& limits,
                CheckResult& result) {
  result.speed = {speed, 0};
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec3 leg = way[i] - way[i - 1];
    if (leg.isZero(0)) continue;
    const Vec3 v = leg * (speed / leg.norm());
    const auto hold = [&](const std::optional<double>& limit, std::string_view why, double value) {
      if (limit && value > *limit * (1 + kSlack)) {
        refuse(result, why, static_cast<double>(i - 1), way[i - 1], value);
      }
    };
    hold(limits.vmax, "speed", v.norm());
    hold(limits.vmax_h, "horizontal_speed", across(v));
    hold(limits.vmax_v, "vertical_speed", std::abs(v.z()));
  }
}

void check_envelope(const Flown& flown, CheckResult& result) {
  const FlightEnvelope& envelope = *flown.envelope;
  const Vec3& first = flown.path.front();
  const Vec3 home(first.x(), first.y(), flown.ends.takeoff_from.value_or(first.z()));
  const std::size_t ascent = flown.ends.takeoff_from ? 1 : 0;
  for (std::size_t i = 0; i < flown.path.size(); ++i) {
    const Vec3& p = flown.path[i];
    const double leg = static_cast<double>(i + ascent) - 1;
    const double height = p.z() - home.z();
    const double away = (p - home).norm();
    if (height > envelope.ceiling) refuse(result, "ceiling", std::max(leg, 0.0), p, height);
    if (away > envelope.range) refuse(result, "range", std::max(leg, 0.0), p, away);
  }
  if (flown.airborne > envelope.endurance) {
    refuse(result, "endurance", static_cast<double>(flown.path.size() - 1 + ascent),
           flown.path.back(), flown.airborne);
  }
}

CheckResult check_way(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits) {
  const auto way = whole_way(scene, flown);
  if (!way) {
    CheckResult result;
    const double room = flown.path.front().z() - *flown.ends.takeoff_from;
    refuse(result, "takeoff", 0, flown.path.front(), room);
    return result;
  }
  CheckResult result = check_path(scene, *way);
  if (flown.speed) check_legs(*way, *flown.speed, limits, result);
  if (flown.envelope) check_envelope(flown, result);
  result.duration = flown.airborne;
  return result;
}

}  // namespace

std::optional<geom::Polyline> whole_way(const geom::CollisionScene& scene, const Flown& flown) {
  geom::Polyline way = flown.path;
  const auto above = [&](const Vec3& p, double ground) {
    return Vec3(p.x(), p.y(), ground + scene.half().z() + kStanding);
  };
  if (flown.ends.takeoff_from) {
    const Vec3 foot = above(way.front(), *flown.ends.takeoff_from);
    if (foot.z() > way.front().z()) return std::nullopt;
    way.insert(way.begin(), foot);
  }
  if (flown.ends.landing_on) {
    const Vec3 foot = above(way.back(), *flown.ends.landing_on);
    if (foot.z() < way.back().z()) way.push_back(foot);
  }
  return way;
}

CheckOptions file_tolerance(const Limits& limits) {
  CheckOptions options;
  options.limits = limits;
  options.position_gap = 1e-3;
  options.velocity_gap = 1e-2;
  options.acceleration_gap = 1e-1;
  options.yaw_gap = 1e-3;
  options.yaw_rate_gap = 1e-2;
  options.limit_slack = kSlack;
  return options;
}

CheckResult check_flown(const geom::CollisionScene& scene, const Flown& flown,
                        const Limits& limits) {
  if (!flown.path.empty()) return check_way(scene, flown, limits);
  if (!flown.setpoints.empty()) return check_setpoints(scene, flown, limits);
  return check(scene, flown.trajectory, file_tolerance(limits));
}

}  // namespace traj
