#include "traj/proof/flown.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "check_limits.h"
#include "curve/curve_piece.h"
#include "curve/portable_math.h"

namespace traj {
namespace {

constexpr double kStanding = 1e-3;  // m: what stands touches, so the check begins above
constexpr double kSlack = 1e-3;     // relative, on limits

void refuse(CheckResult& result, Reason reason, double time, const Vec3& place, double worst) {
  if (result.reason != Reason::none) return;
  result.ok = false;
  result.reason = reason;
  result.time = time;
  result.place = place;
  result.worst = worst;
}

// --- setpoints ------------------------------------------------------------------------------

double across(const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

// The fastest that a force turns on its straight way from `a` to `b` in `dt` seconds: |a x b| is as
// large all along, and the force is least where it is nearest to nothing.
double turn_rate(const Vec3& a, const Vec3& b, double dt) {
  const Vec3 way = b - a;
  const double squared = way.squaredNorm();
  const double s = squared > 0 ? std::clamp(-a.dot(way) / squared, 0.0, 1.0) : 0;
  const double least = (a + s * way).squaredNorm();
  const double turned = a.cross(b).norm();
  if (turned == 0 && least > 0) return 0;
  return least > 0 ? turned / (least * dt) : kInfinity;
}

class SetpointCheck {
 public:
  SetpointCheck(const Limits& limits, CheckResult& result) : limits_(limits), result_(result) {}

  void at(const Setpoint& s) {
    time_ = s.time;
    place_ = s.state.position;
    noise_ = 0;
    hold_velocity(s.state.velocity);
    hold_acceleration(s.state.acceleration);
    hold(Limit::yaw_rate, std::abs(s.yaw_rate));
  }

  // What leads from one setpoint to the next.
  void between(const Setpoint& s, const Setpoint& next) {
    const double dt = next.time - s.time;
    const auto slope = [&](const Vec3& from, const Vec3& to) { return Vec3((to - from) / dt); };
    time_ = s.time;
    place_ = s.state.position;
    const double most = largest(s.state) + largest(next.state);
    noise_ = 64 * std::numeric_limits<double>::epsilon() * most / dt;
    hold_velocity(slope(s.state.position, next.state.position));
    hold_acceleration(slope(s.state.velocity, next.state.velocity));
    hold(Limit::jerk, slope(s.state.acceleration, next.state.acceleration).norm());
    hold(Limit::body_rate,
         turn_rate(force(s.state.acceleration), force(next.state.acceleration), dt));
    hold(Limit::yaw_rate, std::abs(std::remainder(next.yaw - s.yaw, 2 * kPi)) / dt);
  }

 private:
  static double largest(const State& s) {
    return s.position.norm() + s.velocity.norm() + s.acceleration.norm();
  }
  static Vec3 force(const Vec3& acceleration) { return acceleration + Vec3(0, 0, kGravity); }

  void hold_velocity(const Vec3& v) {
    hold(Limit::speed, v.norm());
    hold(Limit::horizontal_speed, across(v));
    hold(Limit::vertical_speed, std::abs(v.z()));
  }

  void hold_acceleration(const Vec3& a) {
    const Vec3 f = force(a);
    hold(Limit::acceleration, a.norm());
    hold(Limit::tilt, f.isZero(0) ? kPi : angle_of(f.z(), across(f)));
    hold(Limit::thrust, f.norm());
  }

  void hold(Limit limit, double value) {
    std::optional<Extreme>& extreme = result_.largest[limit];
    const double sure = std::max(0.0, value - noise_);  // the file's digits show no more
    if (!extreme || sure > extreme->value) extreme = {sure, time_};
    const std::optional<double>& most = limits_[limit];
    if (most && sure > *most * (1 + kSlack)) {
      refuse(result_, broken(limit), time_, place_, sure);
    }
  }

  const Limits& limits_;
  CheckResult& result_;
  double time_ = 0;
  double noise_ = 0;  // what rounding of numbers so large may do to a slope
  Vec3 place_ = Vec3::Zero();
};

// How far single precision moves the way between two setpoints.
Vec3 rounding_between(const Vec3& a, const Vec3& b) {
  constexpr double kHalfUnit = 0x1p-24;
  return a.cwiseAbs().cwiseMax(b.cwiseAbs()) * kHalfUnit;
}

// The time at a leg's index and the part of it.
double time_at(const std::vector<Setpoint>& setpoints, double leg) {
  const auto i = std::min(static_cast<std::size_t>(leg), setpoints.size() - 2);
  const double begin = setpoints[i].time;
  return begin + (leg - static_cast<double>(i)) * (setpoints[i + 1].time - begin);
}

CheckResult check_setpoints(const geom::CollisionScene& scene, const Flown& flown,
                            const Limits& limits, Clearance clearance) {
  const auto& setpoints = flown.setpoints;
  geom::Polyline way;
  std::vector<Vec3> stray;
  for (const Setpoint& s : setpoints) {
    if (!way.empty()) stray.push_back(rounding_between(way.back(), s.state.position));
    way.push_back(s.state.position);
  }
  CheckResult result = check_path(scene, way, stray, clearance);
  result.time = time_at(setpoints, result.time);
  if (result.clearance) result.clearance->time = time_at(setpoints, result.clearance->time);
  result.duration = setpoints.back().time - setpoints.front().time;
  SetpointCheck hold(limits, result);
  for (std::size_t i = 0; i < setpoints.size(); ++i) {
    hold.at(setpoints[i]);
    if (i + 1 < setpoints.size()) hold.between(setpoints[i], setpoints[i + 1]);
  }
  return result;
}

// --- paths ----------------------------------------------------------------------------------

// Along a leg in the direction of `leg`: the autopilot does not climb or descend faster than it
// may.
double speed_along(const Flown& flown, const Vec3& leg) {
  const double most = leg.z() > 0 ? flown.climb : flown.descent;
  const double rise = std::abs(leg.z()) / leg.norm();
  return most > 0 && rise > 0 ? std::min(*flown.speed, most / rise) : *flown.speed;
}

void check_legs(const geom::Polyline& way, const Flown& flown, const Limits& limits,
                CheckResult& result) {
  for (const Limit limit : {Limit::speed, Limit::horizontal_speed, Limit::vertical_speed}) {
    result.largest[limit] = Extreme{};
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec3 leg = way[i] - way[i - 1];
    if (leg.isZero(0)) continue;
    const double speed = speed_along(flown, leg);
    const Vec3 v = leg * (speed / leg.norm());
    const auto index = static_cast<double>(i - 1);
    const auto hold = [&](Limit limit, double value) {
      std::optional<Extreme>& extreme = result.largest[limit];
      if (value > extreme->value) extreme = {value, index};
      const std::optional<double>& most = limits[limit];
      if (most && value > *most * (1 + kSlack)) {
        refuse(result, broken(limit), index, way[i - 1], value);
      }
    };
    hold(Limit::speed, speed);
    hold(Limit::horizontal_speed, across(v));
    hold(Limit::vertical_speed, std::abs(v.z()));
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
    if (height > envelope.ceiling) refuse(result, Reason::ceiling, std::max(leg, 0.0), p, height);
    if (away > envelope.range) refuse(result, Reason::range, std::max(leg, 0.0), p, away);
  }
  if (flown.airborne > envelope.endurance) {
    refuse(result, Reason::endurance, static_cast<double>(flown.path.size() - 1 + ascent),
           flown.path.back(), flown.airborne);
  }
}

// Of each leg of the whole way. Where a vehicle stands is known, so its height above that is not
// blurred by the rounding of others.
std::vector<Vec3> strays(const Flown& flown, std::size_t points) {
  if (flown.path_stray.isZero(0)) return {};
  std::vector<Vec3> stray(std::max<std::size_t>(points - 1, 1), flown.path_stray);
  const std::size_t ascent = flown.ends.takeoff_from ? 1 : 0;
  if (ascent) stray.front().z() = 0;
  if (flown.path.size() + ascent < points) stray.back().z() = 0;
  return stray;
}

// Of a leg of the whole way, at a time that counts legs.
std::optional<FlightPart> part_of(const Flown& flown, double time) {
  if (flown.legs.empty()) return std::nullopt;
  const std::size_t leg = static_cast<std::size_t>(time) + (flown.ends.takeoff_from ? 0 : 1);
  return flown.legs[std::min(leg, flown.legs.size() - 1)];
}

// Legs too.
std::vector<Sweep> all_sweeps(const Flown& flown, const geom::Polyline& way) {
  std::vector<Sweep> sweeps;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto part = part_of(flown, static_cast<double>(i - 1));
    sweeps.push_back({{way[i - 1], way[i]}, part.value_or(FlightPart{})});
  }
  if (way.size() == 1) sweeps.push_back({{way.front()}, {}});
  sweeps.insert(sweeps.end(), flown.sweeps.begin(), flown.sweeps.end());
  return sweeps;
}

// The first leg of an item.
double leg_of(const Flown& flown, std::size_t item) {
  std::size_t leg = 0;
  while (leg + 1 < flown.legs.size() && flown.legs[leg].item != item) ++leg;
  return static_cast<double>(flown.ends.takeoff_from || leg == 0 ? leg : leg - 1);
}

constexpr double kLevel = 1;  // m: ground that is as high as a file says

// How far beside the place that it comes to the ground may be.
Vec3 beside(const Flown& flown) {
  Vec3 most = flown.path_stray;
  for (const Drift& drift : flown.drift) most = most.cwiseMax(flown.path_stray + drift.around);
  return most + flown.navigation;
}

// It lands where home's ground is, not on what stands there or hangs below: that it would land on
// that is in no file.
void require_home_ground(const geom::CollisionScene& scene, const Flown& flown, const Vec3& rally,
                         Reason reason, CheckResult& result) {
  const LandingGround ground = landing_ground(scene, rally, beside(flown), kLevel);
  const double home = flown.home ? flown.home->z() : ground.height;
  const Vec3 foot(rally.x(), rally.y(), ground.height);
  const Vec3 half = scene.half();
  const Vec3 low(rally.x(), rally.y(), ground.height + half.z() + kStanding);
  const bool clear = low.z() > rally.z() || !scene.hits(rally, low);
  if (clear && ground.whole && std::abs(ground.height - home) <= kLevel) return;
  refuse(result, reason, static_cast<double>(flown.legs.size()) - 1, foot, ground.height - home);
}

// A vehicle that lands sinks until it touches, whatever height its file says: there must be ground
// at that height, and level wherever it may come down.
void require_landing(const geom::CollisionScene& scene, const Flown& flown,
                     const geom::Polyline& way, CheckResult& result) {
  if (!flown.ends.landing_on && !flown.lands_below) return;
  const Vec3& above = flown.path.back();
  const LandingGround ground = landing_ground(scene, above, beside(flown), kLevel);
  const double said = flown.ends.landing_on.value_or(ground.height);
  if (ground.whole && std::abs(ground.height - said) <= kLevel) return;
  if (result.reason == Reason::none) {
    result.part = FlightPart{flown.legs.empty() ? 0 : flown.legs.back().item, Manoeuvre::landing};
  }
  refuse(result, Reason::landing, static_cast<double>(way.size()) - 1,
         {above.x(), above.y(), ground.height}, said - ground.height);
  result.looked = true;
}

void check_regions(const geom::CollisionScene& scene, const Flown& flown, const geom::Polyline& way,
                   CheckResult& result) {
  if (result.reason != Reason::none) return;
  check_sweeps(scene, flown.sweeps, flown.path_stray, result);
  check_drift(scene, flown.drift, flown.path_stray, flown.navigation, result);
  if (!flown.fences.empty()) {
    check_fences(scene, all_sweeps(flown, way), flown.fences, flown.path_stray, result);
    check_fences(scene, flown.drift, flown.fences, flown.path_stray, flown.navigation, result);
  }
  if (result.part) result.time = leg_of(flown, result.part->item);
  for (const Vec3& rally : flown.rally) {
    require_home_ground(scene, flown, rally, Reason::return_home, result);
  }
  for (const Vec3& place : flown.touches) {
    require_home_ground(scene, flown, place, Reason::landing, result);
  }
}

CheckResult check_way(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits,
                      Clearance clearance) {
  const auto way = whole_way(scene, flown);
  if (!way) {
    CheckResult result;
    const double room = flown.path.front().z() - *flown.ends.takeoff_from;
    refuse(result, Reason::takeoff, 0, flown.path.front(), room);
    result.looked = true;
    result.part = part_of(flown, 0);
    return result;
  }
  CheckResult result = check_path(scene, *way, strays(flown, way->size()), clearance);
  if (result.reason != Reason::none) result.part = part_of(flown, result.time);
  check_regions(scene, flown, *way, result);
  require_landing(scene, flown, *way, result);
  if (flown.speed) check_legs(*way, flown, limits, result);
  if (flown.envelope) check_envelope(flown, result);
  if (flown.returns) {
    refuse(result, Reason::return_home, static_cast<double>(way->size()) - 1, way->back(), 0);
  }
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
  if (flown.ends.landing_on || flown.lands_below) {
    const double ground =
        flown.lands_below ? ground_below(scene, way.back()) : *flown.ends.landing_on;
    const Vec3 foot = above(way.back(), ground);
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
  options.step_share = 1e-2;
  options.limit_slack = kSlack;
  return options;
}

namespace {

CheckResult check_as_said(const geom::CollisionScene& scene, const Flown& flown,
                          const Limits& limits, Clearance clearance) {
  if (!flown.path.empty()) return check_way(scene, flown, limits, clearance);
  if (!flown.setpoints.empty()) return check_setpoints(scene, flown, limits, clearance);
  CheckOptions options = file_tolerance(limits);
  options.clearance = clearance;
  options.stray = flown.stray;
  return check(scene, flown.trajectory, options);
}

}  // namespace

CheckResult check_flown(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits,
                        Clearance clearance) {
  CheckResult result = check_as_said(scene, flown, limits, clearance);
  if (!result.ok || !flown.drift.empty() || flown.navigation.isZero(0)) return result;
  geom::Vehicle larger = scene.vehicle();
  larger.half += flown.navigation;
  CheckResult strayed = check_as_said(geom::CollisionScene(scene.map(), larger, 0), flown, limits,
                                      Clearance::left_out);
  if (strayed.ok) return result;
  strayed.clearance = result.clearance;
  strayed.strayed = "navigation and tracking";
  return strayed;
}

}  // namespace traj
