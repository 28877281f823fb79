#include "traj/check/check_tube_record.h"

#include <fmt/format.h>

#include <numbers>

#include "geom/base/error.h"
#include "traj/flight/tilted_radius.h"

namespace traj {

TubeReport check_in_tube(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                         const TubeRecord& tube, const std::optional<Vec3>& body) {
  const geom::Vehicle& vehicle = scene.vehicle();
  if (!body && !holds_at_tilt(vehicle, tube.claim.tilt)) {
    constexpr double degrees = 180 / std::numbers::pi;
    throw geom::InputError(
        record.id,
        {.expected = fmt::format("a tube with tilts up to {:.3g} degrees, which the vehicle's half "
                                 "sizes hold",
                                 *vehicle.limits[geom::Limit::tilt] * degrees),
         .found = fmt::format("one of {:.3g}", tube.claim.tilt * degrees),
         .advice = "give --vehicle FILE, whose body says what it needs then"});
  }
  return {tube.claim,
          check_tube(scene, record.trajectory,
                     tilted_radius(tube.radius, tube.claim.tilt, vehicle, body), tube.period),
          scene.margin()};
}

}  // namespace traj
