#include <geom/collision/collision.h>
#include <geom/import/import_boxes.h>
#include <plan/planner/plan.h>
#include <plan/planner/path_record.h>
#include <traj/flight/vehicle_profile.h>
#include <traj/proof/check.h>
#include <traj/record/solved_record.h>
#include <traj/solve/solve.h>

#include <iostream>

// A city as blocks on stdin; on stdout a proved flight through it, as a record for skyway-check.
int main() try {
  const geom::MadeMap made = geom::make_map(
      geom::import_boxes(std::cin, geom::kBlockText, "stdin"), "stdin");
  const traj::VehicleProfile tello = *traj::vehicle_named("tello");
  const geom::CollisionScene scene(made.map, tello.vehicle, 0.2);

  plan::Planner planner(scene);
  const plan::PlanResult path = planner.plan({1, 1, 1}, {9, 1, 1});
  if (path.status != geom::PathStatus::found) throw std::runtime_error(path.message);

  traj::SolveOptions options;
  options.limits = tello.vehicle.limits;
  options.limits[geom::Limit::acceleration] = 3;
  const traj::SolveResult flight = traj::solve(scene, path.path, options);
  if (!flight.rung || !traj::check(scene, flight.trajectory, options.limits).ok) return 1;

  std::cout << to_json_line(traj::trajectory_record(scene, "q1", flight, options.limits));
} catch (const std::exception& error) {
  std::cerr << "flight: " << error.what() << '\n';
  return 2;
}
