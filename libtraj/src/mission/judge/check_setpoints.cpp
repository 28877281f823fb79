#include "check_setpoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/curve_piece.h"
#include "curve/portable_math.h"
#include "geom/shape/polyline.h"
#include "mission/judge/refuse.h"

namespace traj {
namespace {

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
    if (most && sure > *most * (1 + kFileSlack)) {
      refuse(result_, broken(limit), {sure, time_, place_});
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

}  // namespace

CheckResult check_setpoints(const geom::CollisionScene& scene,
                            const std::vector<Setpoint>& setpoints, const Limits& limits,
                            Clearance clearance) {
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

}  // namespace traj
