#include "home/braking.h"

#include <algorithm>
#include <numeric>

#include "traj/home/return_sweeps.h"

namespace traj {

Braking braking_of(std::span<const ReturnModel> models, const FlightStage& stage) {
  Braking out;
  for (std::size_t i = 0; i < models.size(); ++i) {
    Prism one = braking_region(models[i], stage);
    if (i == 0) {
      out.region = std::move(one);
      continue;
    }
    out.region.plan.insert(out.region.plan.end(), one.plan.begin(), one.plan.end());
    out.region.low = std::min(out.region.low, one.low);
    out.region.high = std::max(out.region.high, one.high);
  }
  if (models.size() > 1) out.region.plan = plan_hull(std::move(out.region.plan));
  out.corners = corners(out.region);
  out.middle = std::accumulate(out.corners.begin(), out.corners.end(), Vec3(Vec3::Zero())) /
               static_cast<double>(out.corners.size());
  for (const Velocity& v : stage.velocity) out.speed = std::max(out.speed, v.value.norm());
  out.stands_on = stage.stands_on;
  return out;
}

}  // namespace traj
