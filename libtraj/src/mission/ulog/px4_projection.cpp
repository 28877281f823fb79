#include "traj/mission/ulog/px4_projection.h"

#include <cmath>
#include <numbers>

namespace traj {

geom::GeodeticPlace px4_place(const geom::GeodeticPlace& reference, double north, double east) {
  constexpr double kRadius = 6371000;  // m
  constexpr double kRadian = std::numbers::pi / 180;
  const double far = std::hypot(north, east);
  if (far == 0) return reference;
  const double latitude = reference.latitude * kRadian;
  const double longitude = reference.longitude * kRadian;
  // The reference as a direction from the sphere's middle, and what is up, north and east there.
  const geom::Vec3 up(std::cos(latitude) * std::cos(longitude),
                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
  const geom::Vec3 to_north(-std::sin(latitude) * std::cos(longitude),
                            -std::sin(latitude) * std::sin(longitude), std::cos(latitude));
  const geom::Vec3 to_east(-std::sin(longitude), std::cos(longitude), 0);
  const geom::Vec3 heading = (north * to_north + east * to_east) / far;
  const geom::Vec3 at = std::cos(far / kRadius) * up + std::sin(far / kRadius) * heading;
  return {std::atan2(at.z(), std::hypot(at.x(), at.y())) / kRadian,
          std::atan2(at.y(), at.x()) / kRadian, reference.height};
}

}  // namespace traj
