#include "traj/record/check_in_tube.h"

#include <fmt/format.h>

#include <numbers>

#include "geom/base/error.h"
#include "traj/flight/tilted_radius.h"

namespace traj {

TubeReport check_in_tube(const geom::CollisionScene& scene, std::string_view id,
                         const Trajectory& trajectory, const TubeRecord& tube,
                         const std::optional<Vec3>& body) {
  const geom::Vehicle& vehicle = scene.vehicle();
  if (!body && !holds_at_tilt(vehicle, tube.claim.tilt)) {
    constexpr double degrees = 180 / std::numbers::pi;
    throw geom::InputError(
        id,
        {.expected = fmt::format("a tube with tilts up to {:.3g} degrees, which the vehicle's half "
                                 "sizes hold",
                                 *vehicle.limits[geom::Limit::tilt] * degrees),
         .found = fmt::format("one of {:.3g}", tube.claim.tilt * degrees),
         .advice = "give --vehicle FILE, whose body says what it needs then"});
  }
  return {tube.claim,
          check_tube(scene, trajectory, tilted_radius(tube.radius, tube.claim.tilt, vehicle, body),
                     tube.period),
          scene.margin()};
}

TubeReport check_as_geography(const geom::CollisionScene& scene, std::string_view id,
                              const Trajectory& trajectory, const TubeReports& tubes) {
  const TubeRecord& tube = tubes.require_tube(id, trajectory, geom::provenance_of(scene));
  if (tube.claim.kind != TubeKind::proved) {
    throw geom::InputError(tubes.source(), {.expected = "a proved tube of " + geom::in_quotes(id),
                                            .found = "statistics, which prove nothing",
                                            .advice = "skyway-fly --proved-tube writes one"});
  }
  return check_in_tube(scene, id, trajectory, tube, {});
}

Vec3 geography_half(const geom::Vehicle& vehicle, const TubeReport& tube) {
  return vehicle.half.array() + tube.claim.largest;
}

}  // namespace traj
