#include "traj/home/flight_return.h"

#include <algorithm>
#include <cassert>

#include "geom/base/usage_error.h"
#include "traj/curve/vertical_ends.h"

namespace traj {
namespace {

ReturnModel model_of(const Autopilot& autopilot, const std::optional<double>& height) {
  ReturnModel model = return_model(autopilot);
  if (height) model.height = *height;
  return model;
}

// It returns before its mission switches the fence on, or after that.
void switch_fence_on(const Autopilot& autopilot, ReturnModel& model) {
  if (autopilot.firmware != Firmware::ardupilot) return;
  model.fence_excludes = true;
  if (model.ceiling) return;
  model.ceiling = autopilot.switched_fence.return_ceiling;
  model.keeps_below_ceiling = false;
}

// The ground below an end of a flight, if it is level.
void add_pad(const geom::CollisionScene& scene, const Vec3& end, ReturnTask& task) {
  constexpr double kLevel = 1;  // m
  const LandingGround ground = landing_ground(scene, end, Vec3::Zero(), kLevel);
  if (ground.whole) task.pads.emplace_back(end.x(), end.y(), ground.height);
}

}  // namespace

FlightReturn flight_return(const FlownMission& mission, const Flier& flier,
                           const std::optional<double>& height) {
  assert(mission.home);
  FlightReturn out;
  out.task.home = *mission.home;
  out.task.rally = mission.rally_points;
  out.task.fences = mission.fences;
  out.task.room = flier.allowance(false);
  for (const Drift& drift : mission.drift) {
    const auto autopilot =
        std::find_if(flier.autopilots.begin(), flier.autopilots.end(),
                     [&](const Autopilot& one) { return one.name == drift.autopilot; });
    assert(autopilot != flier.autopilots.end());  // the mission was read for this flier
    out.task.models.push_back(model_of(*autopilot, flier.return_height(height)));
    if (mission.switches_fence) switch_fence_on(*autopilot, out.task.models.back());
    out.task.models.back().around += mission.path_stray;
    out.stages.push_back(stages_of(drift));
  }
  if (!mission.drift.empty()) out.timeline = timeline_of(mission.drift.front());
  return out;
}

FlightReturn dji_flight_return(const geom::CollisionScene& scene, FlownMission mission,
                               const Flier& flier, const DjiReturnAsked& asked) {
  if (mission.lands_below && !mission.ends.landing_on) {
    mission.ends.landing_on = ground_below(scene, mission.path.back());
  }
  const auto height = mission.return_height ? mission.return_height : asked.height;
  if (!height && asked.height_counts) {
    throw geom::UsageError(
        "the height of the return is a setting of the aircraft: give it with --return-height");
  }
  auto speed = mission.speed ? mission.speed : mission.speed_before_return;
  if (!speed) speed = asked.speed;
  if (!speed) {
    throw geom::UsageError(
        "the mission does not say its speed, so nobody knows how far it brakes: give it with "
        "--vmax");
  }
  FlightReturn out = flight_return(mission, flier, height);
  out.task.models.push_back(dji_return_model(height.value_or(0)));
  out.task.models.back().around += mission.path_stray;
  out.stages.push_back(stages_of(mission, *speed));
  out.timeline = timeline_of(mission, *speed);
  return out;
}

FlightReturn flight_return(const geom::CollisionScene& scene,
                           const std::vector<FlightStage>& stages, const Vec3& begin,
                           const Vec3& end, const Flier& flier,
                           const std::optional<double>& height) {
  FlightReturn out;
  out.task.home = {begin.x(), begin.y(), ground_below(scene, begin)};
  out.task.room =
      flier.allowance(true);  // the model of an autopilot says how missions are followed
  add_pad(scene, begin, out.task);
  add_pad(scene, end, out.task);
  for (const Autopilot& autopilot : flier.autopilots) {
    out.task.models.push_back(model_of(autopilot, flier.return_height(height)));
  }
  out.stages.assign(out.task.models.size(), stages);
  return out;
}

FlightReturn flight_return(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           const Flier& flier, const std::optional<double>& height) {
  return flight_return(scene, stages_of(trajectory), trajectory.segments.front().point.front(),
                       trajectory.segments.back().point.back(), flier, height);
}

}  // namespace traj
