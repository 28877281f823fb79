#include "traj/flight/tilted_radius.h"

#include <algorithm>
#include <numbers>

namespace traj {

bool holds_at_tilt(const geom::Vehicle& vehicle, double tilt) {
  const auto& most = vehicle.limits[geom::Limit::tilt];
  return !most || tilt <= *most;
}

std::vector<double> tilted_radius(std::span<const double> radius, double tilt,
                                  const geom::Vehicle& vehicle,
                                  const std::optional<geom::Vec3>& body) {
  std::vector<double> out(radius.begin(), radius.end());
  if (!body || holds_at_tilt(vehicle, tilt)) return out;
  const geom::Vec3 more = geom::attitude_half_sizes(*body, std::min(tilt, std::numbers::pi / 2)) -
                          geom::attitude_half_sizes(*body, *vehicle.limits[geom::Limit::tilt]);
  for (double& r : out) r += more.cwiseMax(0).norm();
  return out;
}

}  // namespace traj
