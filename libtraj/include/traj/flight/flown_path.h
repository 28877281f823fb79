#pragma once

// Whether a flown path is clear of a map.
//
// Example:
//   const std::vector<double> radius = {0.05};  // m that the vehicle may stray from the trajectory
//   const traj::FlightPathCheck check = traj::check_tube(scene, trajectory, radius, 0.1);
//   if (!check.clear) std::cout << traj::name(check.reason) << " at " << check.time << " s\n";

#include <functional>
#include <optional>

#include "geom/collision/collision.h"
#include "traj/flight/simulate.h"
#include "traj/proof/reason.h"

namespace traj {

struct FlightPathCheck {
  bool clear = false;
  // The first of bounds, collision and undecided along the way. Undecided: the polyline is clear,
  // but the path around it perhaps not.
  Reason reason = Reason::none;
  double time = 0;                 // s
  Vec3 place = Vec3::Zero();       // m, in the map's axes
  std::optional<std::size_t> box;  // the obstacle
  double between = 0;              // m: how far the path may be off the polyline
};

// Exact on the polyline of the integrator's steps; between them the path strays by at most
// A h^2 / 8, where A bounds the acceleration. "Clear" holds with that added to the vehicle.
// `half_at` gives the half sizes that hold the vehicle at a tilt beyond `tilt_max` (radians): where
// it flew so, they count. `quadrotor` is the true one. `flight` has its path.
struct TiltedVehicle {
  double tilt_max = 1.5707963267948966;
  std::function<Vec3(double)> half_at;  // may be empty: the scene's half sizes hold at every tilt
};
FlightPathCheck check_flight_path(const geom::CollisionScene& scene, const Quadrotor& quadrotor,
                                  const TiltedVehicle& vehicle, const Flight& flight);

// Whether the trajectory (in the map's axes) is clear while the vehicle strays from it by up to
// radius[k] metres during [k, k + 1] * period: the moving box of vehicle, margin, radius and the
// curve's sagitta, swept along chords of 10 ms. The last radius goes on. Not clear, with the reason
// of domain.h, where the trajectory is outside of it. Throws InputError for no radius, a radius
// below 0 or not a number, and a period that is not above 0.
FlightPathCheck check_tube(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           std::span<const double> radius, double period);

}  // namespace traj
