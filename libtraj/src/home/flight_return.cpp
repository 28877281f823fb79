#include "traj/home/flight_return.h"

#include <algorithm>
#include <cassert>

#include "traj/curve/vertical_ends.h"

namespace traj {
namespace {

ReturnModel model_of(const Autopilot& autopilot, const std::optional<double>& height) {
  ReturnModel model = return_model(autopilot);
  if (height) model.height = *height;
  return model;
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
    if (autopilot == flier.autopilots.end()) continue;
    out.task.models.push_back(model_of(*autopilot, height));
    out.task.models.back().around += mission.path_stray;
    out.stages.push_back(stages_of(drift));
  }
  return out;
}

FlightReturn flight_return(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           const Flier& flier, const std::optional<double>& height) {
  const Vec3& begin = trajectory.segments.front().point.front();
  FlightReturn out;
  out.task.home = {begin.x(), begin.y(), ground_below(scene, begin)};
  out.task.room = flier.allowance(false);
  for (const Autopilot& autopilot : flier.autopilots) {
    out.task.models.push_back(model_of(autopilot, height));
  }
  out.stages.assign(out.task.models.size(), stages_of(trajectory));
  return out;
}

}  // namespace traj
