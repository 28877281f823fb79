#include "traj/mission/flown/flown.h"

#include <utility>

#include "traj/curve/to_enu.h"

namespace traj {
namespace {

using geom::Axes;

void turn(Axes axes, std::vector<Vec3>& places) {
  for (Vec3& p : places) p = geom::to_enu(axes, p);
}

void turn(Axes axes, std::vector<Sweep>& sweeps) {
  for (Sweep& sweep : sweeps) {
    turn(axes, sweep.hull);
    if (!sweep.motion) continue;
    for (Velocity& velocity : sweep.motion->velocity) {
      velocity.value = geom::to_enu(axes, velocity.value);
      if (velocity.since) velocity.since = geom::to_enu(axes, *velocity.since);
      if (velocity.until) velocity.until = geom::to_enu(axes, *velocity.until);
    }
  }
}

void turn(Axes axes, FlownCurve& curve) {
  curve.trajectory = to_enu(axes, std::move(curve.trajectory));
  for (Stray& stray : curve.stray) stray.position = geom::to_enu(axes, stray.position);
}

void turn(Axes axes, FlownSetpoints& flown) {
  for (Setpoint& s : flown.setpoints) {
    s.yaw = geom::yaw_to_enu(axes, s.yaw);
    if (axes != Axes::enu) s.yaw_rate = -s.yaw_rate;
    for (Vec3* v : {&s.state.position, &s.state.velocity, &s.state.acceleration}) {
      *v = geom::to_enu(axes, *v);
    }
  }
}

void turn(Axes axes, FlownLegs& legs) {
  turn(axes, legs.path);
  legs.path_stray = geom::to_enu(axes, legs.path_stray);
}

void turn(Axes axes, FlownMission& mission) {
  turn(axes, static_cast<FlownLegs&>(mission));
  turn(axes, mission.sweeps);
  for (Drift& drift : mission.drift) {
    turn(axes, drift.sweeps);
    drift.around = geom::to_enu(axes, drift.around);
    for (TimedLeg& leg : drift.legs) {
      leg.a = geom::to_enu(axes, leg.a);
      leg.b = geom::to_enu(axes, leg.b);
    }
  }
  for (Fence& fence : mission.fences) {
    for (geom::Vec2& p : fence.ring) p = geom::to_enu(axes, {p.x(), p.y(), 0}).head<2>();
  }
  turn(axes, mission.rally);
  turn(axes, mission.rally_points);
  turn(axes, mission.touches);
  if (mission.home) mission.home = geom::to_enu(axes, *mission.home);
}

}  // namespace

double band_of(const FlownLegs& flown, std::size_t leg) {
  const std::size_t ascent = flown.ends.takeoff_from ? 1 : 0;
  const bool has = leg >= ascent && leg - ascent < flown.leg_band.size();
  return has ? flown.leg_band[leg - ascent] : 0;
}

const FlownLegs* legs_of(const Flown& flown) {
  if (const FlownMission* mission = mission_of(flown)) return mission;
  return std::get_if<FlownLegs>(&flown.way);
}

const FlownMission* mission_of(const Flown& flown) { return std::get_if<FlownMission>(&flown.way); }

bool has_drift(const Flown& flown) {
  const FlownMission* mission = mission_of(flown);
  return mission && !mission->drift.empty();
}

Trajectory straight_between(const std::vector<Setpoint>& setpoints) {
  Trajectory trajectory;
  for (std::size_t i = 1; i < setpoints.size(); ++i) {
    const Vec3& a = setpoints[i - 1].state.position;
    const Vec3& b = setpoints[i].state.position;
    trajectory.segments.push_back(
        {setpoints[i].time - setpoints[i - 1].time, {a, a, a, a, b, b, b, b}, {}});
  }
  return trajectory;
}

Trajectory trajectory_of(const Flown& flown) {
  if (const auto* curve = std::get_if<FlownCurve>(&flown.way)) return curve->trajectory;
  const auto* setpoints = std::get_if<FlownSetpoints>(&flown.way);
  return setpoints ? straight_between(setpoints->setpoints) : Trajectory{};
}

Vec3 begin_of(const Flown& flown) {
  if (const FlownLegs* legs = legs_of(flown)) return legs->path.front();
  if (const auto* curve = std::get_if<FlownCurve>(&flown.way)) {
    return curve->trajectory.segments.front().point.front();
  }
  return std::get<FlownSetpoints>(flown.way).setpoints.front().state.position;
}

Flown to_enu(Axes axes, Flown flown) {
  std::visit([&](auto& way) { turn(axes, way); }, flown.way);
  flown.navigation = geom::to_enu(axes, flown.navigation);
  return flown;
}

}  // namespace traj
