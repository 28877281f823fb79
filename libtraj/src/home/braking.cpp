#include "home/braking.h"

#include <algorithm>
#include <numeric>

#include "traj/home/return_sweeps.h"

namespace traj {

Braking braking_of(std::span<const ReturnModel> models, const FlightStage& stage) {
  std::vector<Vec3> all;
  for (const ReturnModel& model : models) {
    const std::vector<Vec3> one = corners(braking_region(model, stage));
    all.insert(all.end(), one.begin(), one.end());
  }
  Braking out;
  out.region = prism_around(all);
  out.corners = corners(out.region);
  out.middle = std::accumulate(out.corners.begin(), out.corners.end(), Vec3(Vec3::Zero())) /
               static_cast<double>(out.corners.size());
  for (const Velocity& v : stage.velocity) out.speed = std::max(out.speed, v.value.norm());
  out.stands_on = stage.stands_on;
  return out;
}

}  // namespace traj
