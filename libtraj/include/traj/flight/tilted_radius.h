#pragma once

// Radii of a tube whose vehicle tilts further than its half sizes allow for.
//
// Example:
//   const auto quad = traj::vehicle_named("quad2kg");
//   const double tilt = *quad->vehicle.limits[geom::Limit::tilt];
//   assert(traj::tilted_radius({{0.1}}, tilt, quad->vehicle, quad->body) == std::vector{0.1});
//   assert(traj::tilted_radius({{0.1}}, tilt + 0.2, quad->vehicle, quad->body)[0] > 0.1);

#include <optional>
#include <span>
#include <vector>

#include "geom/vehicle/vehicle.h"

namespace traj {

// Whether its half sizes hold the vehicle at this tilt, in radians.
bool holds_at_tilt(const geom::Vehicle& vehicle, double tilt);

// The radii, in metres, each with how much further the body (half sizes, metres) reaches at this
// tilt than at the vehicle's limit. They are the same where its half sizes hold it at the tilt, or
// where nobody knows the body.
std::vector<double> tilted_radius(std::span<const double> radius, double tilt,
                                  const geom::Vehicle& vehicle,
                                  const std::optional<geom::Vec3>& body);

}  // namespace traj
