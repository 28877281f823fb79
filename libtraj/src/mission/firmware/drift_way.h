#pragma once

// A mission's way as one autopilot flies it: speeds, stops and times of its legs.

#include <algorithm>
#include <cmath>
#include <vector>

#include "mission/flown/flown_regions.h"
#include "mission_drift.h"

namespace traj {

inline Vec3 level(const Vec3& v) { return {v.x(), v.y(), 0}; }

// Points and the legs to them are counted from 0, where the take-off ends.
class DriftWay {
 public:
  DriftWay(const Autopilot& autopilot, const DriftTask& task) : pilot_(autopilot), task_(task) {}

  // As on these legs; where one of them rises or sinks, so may the vehicle on all.
  Motion along(std::size_t first, std::size_t last) const {
    Motion motion{first, last, {}};
    bool rises = first == 0;
    bool sinks = last >= task_.path.size();
    for (std::size_t i = std::max<std::size_t>(first, 1); i <= last && i < task_.path.size(); ++i) {
      motion.velocity.push_back(velocity(i));
      rises = rises || direction(i).z() > 0;
      sinks = sinks || direction(i).z() < 0;
    }
    if (rises) motion.velocity.push_back({{0, 0, pilot_.climb}});
    if (sinks) motion.velocity.push_back({{0, 0, -pilot_.descent}});
    return motion;
  }

  // From the ground to the ground: the take-off first, then the leg to each point, the landing.
  std::vector<TimedLeg> timed_legs() const {
    std::vector<TimedLeg> legs;
    const Vec3& first = at(0);
    const double ground = task_.ends.takeoff_from.value_or(first.z());
    double now = std::max(0.0, first.z() - ground) / pilot_.climb;
    legs.push_back(
        {{first.x(), first.y(), std::min(ground, first.z())}, first, 0, now, task_.legs[0]});
    for (std::size_t i = 1; i < task_.path.size(); ++i) {
      now += task_.hold[i - 1];
      const double arrives = now + seconds(i);
      legs.push_back({at(i - 1), at(i), now, arrives, task_.legs[i]});
      now = arrives;
    }
    if (!task_.ends.landing_on) return legs;
    const Vec3& last = at(task_.path.size() - 1);
    now += task_.hold.back();
    const double sinks = std::max(0.0, last.z() - *task_.ends.landing_on) / pilot_.descent;
    legs.push_back(
        {last, {last.x(), last.y(), *task_.ends.landing_on}, now, now + sinks, task_.landing});
    return legs;
  }

  Vec3 direction(std::size_t i) const {
    const Vec3 way = at(i) - at(i - 1);
    const double length = way.norm();
    return length > 0 ? Vec3(way / length) : Vec3(Vec3::Zero());
  }

  double length(std::size_t i) const { return (at(i) - at(i - 1)).norm(); }

  // The most that the leg to a point is flown with, m/s: its climb or descent may hold it back.
  double speed(std::size_t i) const {
    const double asked = task_.speeds[i].value_or(pilot_.speed);
    const double rise = direction(i).z();
    const double most = rise > 0 ? pilot_.climb : pilot_.descent;
    return std::abs(rise) > 0 ? std::min(asked, most / std::abs(rise)) : asked;
  }

  // The same where the leg ends: it may still be slowing down from a faster one, with half of the
  // acceleration that it may.
  double speed_at_end(std::size_t i) const {
    double fastest = speed(i);
    double way = length(i);
    for (std::size_t k = i - 1; k > 0 && !stops(k); --k) {
      const double left = speed(k) * speed(k) - pilot_.acceleration * way;
      if (left > fastest * fastest) fastest = std::sqrt(left);
      way += length(k);
      if (way > kFarBack) break;
    }
    return fastest;
  }

  // How far a stop at a point is overshot.
  Vec3 overshoot(std::size_t i) const {
    if (i == 0) return Vec3::Zero();
    const Vec3 along = level(direction(i));
    return along * (pilot_.overshoot_time * speed_at_end(i) + pilot_.overshoot);
  }

  // Of the fastest leg: splines leave to any side.
  double furthest_overshoot() const {
    double fastest = 0;
    for (const auto& one : task_.speeds) fastest = std::max(fastest, one.value_or(pilot_.speed));
    return pilot_.overshoot_time * fastest + pilot_.overshoot;
  }

  // A point of the next leg where a corner, or a stop that was overshot, has decayed.
  Vec3 settled(std::size_t i, double speed, const Settling& settling) const {
    return before_corner(at(i + 1), at(i), settling.distance + settling.time * speed);
  }

  double radius(std::size_t i) const {
    const double said = task_.turns[i].said;
    return pilot_.heeds_item_radius && said > 0 ? said : pilot_.acceptance;
  }

  bool is_leg(std::size_t i) const {
    const Manoeuvre manoeuvre = task_.legs[i].manoeuvre;
    return manoeuvre == Manoeuvre::leg || manoeuvre == Manoeuvre::spline ||
           manoeuvre == Manoeuvre::hover;
  }

  // Rests there, as this autopilot counts it.
  bool stops(std::size_t i) const {
    const Manoeuvre manoeuvre = task_.legs[i].manoeuvre;
    if (returns(i)) return !pilot_.heeds_item_radius;
    if (task_.turns[i].kind == Turn::rest) return manoeuvre != Manoeuvre::circle;
    return !pilot_.heeds_item_radius && task_.hold[i] >= 1;
  }

  bool returns(std::size_t i) const { return task_.legs[i].manoeuvre == Manoeuvre::return_home; }

 private:
  const Vec3& at(std::size_t i) const { return task_.path[i]; }

  // On the leg to a point.
  Velocity velocity(std::size_t i) const {
    Velocity out{direction(i) * speed_at_end(i)};
    if (i > 1 && stops(i - 1)) out.since = at(i - 1);
    if (i + 1 == task_.path.size() || stops(i)) out.until = at(i);
    return out;
  }

  // Of the leg to a point: at its speed, and what speeding up from a rest and slowing down takes.
  double seconds(std::size_t i) const {
    const double fast = speed(i);
    const double ramp = fast / (2 * pilot_.acceleration);
    const bool from_rest = i == 1 || stops(i - 1);
    const bool to_rest = i + 1 == task_.path.size() || stops(i);
    return length(i) / fast + (from_rest ? ramp : 0) + (to_rest ? ramp : 0);
  }

  static constexpr double kFarBack = 200;  // m: no speed lasts so long

  const Autopilot& pilot_;
  const DriftTask& task_;
};

}  // namespace traj
