#include "traj/mission/judge/judge.h"

#include <algorithm>
#include <cmath>

#include "mission/judge/check_setpoints.h"
#include "mission/judge/refuse.h"
#include "traj/mission/judge/regions.h"

namespace traj {
namespace {

constexpr double kStanding = 1e-3;  // m: what stands touches, so the check begins above

// Along a leg in the direction of `leg`: the autopilot does not climb or descend faster than it
// may.
double speed_along(const FlownLegs& flown, const Vec3& leg) {
  const double most = leg.z() > 0 ? flown.climb : flown.descent;
  const double rise = std::abs(leg.z()) / leg.norm();
  return most > 0 && rise > 0 ? std::min(*flown.speed, most / rise) : *flown.speed;
}

void check_legs(const geom::Polyline& way, const FlownLegs& flown, const Limits& limits,
                CheckResult& result) {
  for (const Limit limit : {Limit::speed, Limit::horizontal_speed, Limit::vertical_speed}) {
    result.largest[limit] = Extreme{};
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec3 leg = way[i] - way[i - 1];
    if (leg.isZero(0)) continue;
    const double along = speed_along(flown, leg);
    Vec3 v = leg * (along / leg.norm());
    // Over terrain it rises and sinks to follow that, and need not slow down for it.
    if (!flown.leg_band.empty()) {
      const double level = across(leg);
      if (level > 0) v.head<2>() = leg.head<2>() * (*flown.speed / level);
      const double follows = std::max(flown.climb, flown.descent);
      v.z() = flown.climb_holds_in_band ? std::max(std::abs(v.z()), follows)
                                        : std::abs(v.z()) + follows;
    }
    const double speed = flown.leg_band.empty() ? along : v.norm();
    const auto index = static_cast<double>(i - 1);
    const auto hold = [&](Limit limit, double value) {
      std::optional<Extreme>& extreme = result.largest[limit];
      if (value > extreme->value) extreme = {value, index};
      const std::optional<double>& most = limits[limit];
      if (most && value > *most * (1 + kFileSlack)) {
        refuse(result, broken(limit), {value, index, way[i - 1]});
      }
    };
    hold(Limit::speed, speed);
    hold(Limit::horizontal_speed, across(v));
    hold(Limit::vertical_speed, std::abs(v.z()));
  }
}

void check_envelope(const FlownLegs& flown, CheckResult& result) {
  const FlightEnvelope& envelope = *flown.envelope;
  const Vec3& first = flown.path.front();
  const Vec3 home(first.x(), first.y(), flown.ends.takeoff_from.value_or(first.z()));
  const std::size_t ascent = flown.ends.takeoff_from ? 1 : 0;
  for (std::size_t i = 0; i < flown.path.size(); ++i) {
    const Vec3& p = flown.path[i];
    const double leg = static_cast<double>(i + ascent) - 1;
    const double height = p.z() - home.z();
    const double away = (p - home).norm();
    if (height > envelope.ceiling) refuse(result, Reason::ceiling, {height, std::max(leg, 0.0), p});
    if (away > envelope.range) refuse(result, Reason::range, {away, std::max(leg, 0.0), p});
  }
  if (flown.airborne > envelope.endurance) {
    refuse(
        result, Reason::endurance,
        {flown.airborne, static_cast<double>(flown.path.size() - 1 + ascent), flown.path.back()});
  }
}

// Of each leg of the whole way. Where a vehicle stands is known, so its height above that is not
// blurred by the rounding of others.
std::vector<Vec3> strays(const FlownLegs& flown, std::size_t points) {
  if (flown.path_stray.isZero(0) && flown.leg_band.empty()) return {};
  std::vector<Vec3> stray(std::max<std::size_t>(points - 1, 1), flown.path_stray);
  const std::size_t ascent = flown.ends.takeoff_from ? 1 : 0;
  for (std::size_t i = 0; i < stray.size(); ++i) stray[i].z() += band_of(flown, i);
  if (ascent) stray.front().z() = 0;
  if (flown.path.size() + ascent < points) stray.back().z() = 0;
  return stray;
}

constexpr double kLevel = 1;  // m: ground that is as high as a file says

// Legs, and the regions beside them where there are any, over one map.
class LegsCheck {
 public:
  LegsCheck(const geom::CollisionScene& scene, const FlownLegs& legs, const FlownMission* mission,
            const Vec3& navigation)
      : scene_(scene), legs_(legs), mission_(mission), navigation_(navigation) {}

  CheckResult check(const Limits& limits, Clearance clearance) const {
    const auto way = whole_way(scene_, legs_);
    if (!way) return refused_takeoff();
    CheckResult result = check_path(scene_, *way, strays(legs_, way->size()), clearance);
    if (result.reason != Reason::none) result.part = part_of(result.time);
    if (mission_) check_regions(*way, result);
    require_takeoff_ground(result);
    require_landing(*way, result);
    if (legs_.speed) check_legs(*way, legs_, limits, result);
    if (legs_.envelope) check_envelope(legs_, result);
    if (mission_ && mission_->returns) {
      refuse(result, Reason::return_home, {0, static_cast<double>(way->size()) - 1, way->back()});
    }
    result.duration = legs_.airborne;
    return result;
  }

 private:
  std::size_t parts() const { return mission_ ? mission_->legs.size() : 0; }

  // Of a leg of the whole way, at a time that counts legs.
  std::optional<FlightPart> part_of(double time) const {
    if (parts() == 0) return std::nullopt;
    const std::size_t leg = static_cast<std::size_t>(time) + (legs_.ends.takeoff_from ? 0 : 1);
    return mission_->legs[std::min(leg, parts() - 1)];
  }

  CheckResult refused_takeoff() const {
    CheckResult result;
    const Vec3& first = legs_.path.front();
    refuse(result, Reason::takeoff, {first.z() - *legs_.ends.takeoff_from, 0, first});
    result.looked = true;
    result.part = part_of(0);
    return result;
  }

  // Legs too.
  std::vector<Sweep> all_sweeps(const geom::Polyline& way) const {
    std::vector<Sweep> sweeps;
    for (std::size_t i = 1; i < way.size(); ++i) {
      const auto part = part_of(static_cast<double>(i - 1));
      sweeps.push_back({{way[i - 1], way[i]}, part.value_or(FlightPart{})});
    }
    if (way.size() == 1) sweeps.push_back({{way.front()}, {}});
    sweeps.insert(sweeps.end(), mission_->sweeps.begin(), mission_->sweeps.end());
    return sweeps;
  }

  // The first leg of an item.
  double leg_of(std::size_t item) const {
    std::size_t leg = 0;
    while (leg + 1 < parts() && mission_->legs[leg].item != item) ++leg;
    return static_cast<double>(legs_.ends.takeoff_from || leg == 0 ? leg : leg - 1);
  }

  // How far beside the place that it comes to the ground may be.
  Vec3 beside() const {
    Vec3 most = legs_.path_stray;
    if (mission_) {
      for (const Drift& drift : mission_->drift) {
        most = most.cwiseMax(legs_.path_stray + drift.around);
      }
    }
    return most + navigation_;
  }

  // It lands where home's ground is, not on what stands there or hangs below: that it would land on
  // that is in no file.
  void require_home_ground(const Vec3& rally, Reason reason, CheckResult& result) const {
    const LandingGround ground = landing_ground(scene_, rally, beside(), kLevel);
    const double home = mission_->home ? mission_->home->z() : ground.height;
    const Vec3 foot(rally.x(), rally.y(), ground.height);
    const Vec3 half = scene_.half();
    const Vec3 low(rally.x(), rally.y(), ground.height + half.z() + kStanding);
    const bool clear = low.z() > rally.z() || !scene_.hits(rally, low);
    if (clear && ground.whole && std::abs(ground.height - home) <= kLevel) return;
    refuse(result, reason, {ground.height - home, static_cast<double>(parts()) - 1, foot});
  }

  // Where the vehicle stands before its flight, and the file counts heights from; nothing where the
  // map does not reach, or where the file does not say.
  std::optional<Vec3> stand() const {
    const Vec3& first = legs_.path.front();
    if (legs_.ends.takeoff_from) return Vec3(first.x(), first.y(), *legs_.ends.takeoff_from);
    if (!mission_ || !mission_->home) return std::nullopt;
    const Vec3& home = *mission_->home;
    const geom::Aabb& bounds = scene_.map().spec().bounds;
    const bool inside = (home.head<2>().array() >= bounds.min.head<2>().array()).all() &&
                        (home.head<2>().array() <= bounds.max.head<2>().array()).all();
    return inside ? mission_->home : std::nullopt;
  }

  // A vehicle takes off from the ground, and its autopilot takes that for home, whatever height the
  // file gives it. If home is in the air, the whole flight is lower than the file says; if it is
  // below the map, higher.
  void require_takeoff_ground(CheckResult& result) const {
    const auto place = stand();
    if (!place) return;
    const Vec3 above = *place + Vec3(0, 0, kStanding);
    const double high = place->z() - landing_ground(scene_, above, beside(), kLevel).height;
    if (std::abs(high) <= kLevel) return;
    if (result.reason == Reason::none) result.part = part_of(0);
    refuse(result, Reason::takeoff_ground, {high, 0, *place});
    result.looked = true;
  }

  // A vehicle that lands sinks until it touches, whatever height its file says: there must be
  // ground at that height, and level wherever it may come down.
  void require_landing(const geom::Polyline& way, CheckResult& result) const {
    if (!legs_.ends.landing_on && !legs_.lands_below) return;
    const Vec3& above = legs_.path.back();
    const LandingGround ground = landing_ground(scene_, above, beside(), kLevel);
    const double said = legs_.ends.landing_on.value_or(ground.height);
    if (ground.whole && std::abs(ground.height - said) <= kLevel) return;
    if (result.reason == Reason::none && mission_) {
      result.part = FlightPart{parts() == 0 ? 0 : mission_->legs.back().item, Manoeuvre::landing};
    }
    refuse(result, Reason::landing,
           {said - ground.height,
            static_cast<double>(way.size()) - 1,
            {above.x(), above.y(), ground.height}});
    result.looked = true;
  }

  void check_regions(const geom::Polyline& way, CheckResult& result) const {
    if (result.reason != Reason::none) return;
    const Vec3& stray = legs_.path_stray;
    check_sweeps(scene_, mission_->sweeps, stray, result);
    check_drift(scene_, mission_->drift, stray, navigation_, result);
    if (!mission_->fences.empty()) {
      check_fences(scene_, all_sweeps(way), mission_->fences, stray, result);
      check_fences(scene_, mission_->drift, mission_->fences, stray, navigation_, result);
    }
    if (result.part) result.time = leg_of(result.part->item);
    for (const Vec3& rally : mission_->rally) {
      require_home_ground(rally, Reason::return_home, result);
    }
    for (const Vec3& place : mission_->touches) {
      require_home_ground(place, Reason::landing, result);
    }
  }

  const geom::CollisionScene& scene_;
  const FlownLegs& legs_;
  const FlownMission* mission_;
  const Vec3& navigation_;
};

CheckResult check_curve(const geom::CollisionScene& scene, const FlownCurve& curve,
                        const Limits& limits, Clearance clearance) {
  CheckOptions options = file_tolerance(limits);
  options.clearance = clearance;
  options.stray = curve.stray;
  return check(scene, curve.trajectory, options);
}

CheckResult judge_as_said(const geom::CollisionScene& scene, const Flown& flown,
                          const Limits& limits, Clearance clearance) {
  if (const FlownLegs* legs = legs_of(flown)) {
    return LegsCheck(scene, *legs, mission_of(flown), flown.navigation).check(limits, clearance);
  }
  if (const auto* curve = std::get_if<FlownCurve>(&flown.way)) {
    return check_curve(scene, *curve, limits, clearance);
  }
  return check_setpoints(scene, std::get<FlownSetpoints>(flown.way).setpoints, limits, clearance);
}

}  // namespace

std::optional<geom::Polyline> whole_way(const geom::CollisionScene& scene, const FlownLegs& flown) {
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
  options.limit_slack = kFileSlack;
  return options;
}

CheckResult judge(const geom::CollisionScene& scene, const Flown& flown, const Limits& limits,
                  Clearance clearance) {
  CheckResult result = judge_as_said(scene, flown, limits, clearance);
  if (!result.ok || has_drift(flown) || flown.navigation.isZero(0)) return result;
  geom::Vehicle larger = scene.vehicle();
  larger.half += flown.navigation;
  CheckResult strayed = judge_as_said(geom::CollisionScene(scene.map(), larger, 0), flown, limits,
                                      Clearance::left_out);
  if (strayed.ok) return result;
  strayed.clearance = result.clearance;
  strayed.strayed = "navigation and tracking";
  return strayed;
}

}  // namespace traj
