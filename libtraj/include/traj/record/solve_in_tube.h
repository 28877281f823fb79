#pragma once

// From a path record to a trajectory whose own proved tube is clear of the map.
//
// Example, not run:
//   traj::TubeTask task{.solve = {.limits = limits}, .profile = *traj::vehicle_named("quad2kg")};
//   task.flight = {.quadrotor = *traj::quadrotor_of(task.profile.airframe)};
//   task.flight.law = traj::ControlLaw::geometric;  // and its gains
//   const traj::TubeRooms rooms{[&](double margin) {
//     return std::make_shared<const geom::CollisionScene>(map, vehicle, margin);
//   }};
//   const geom::PathRecord way{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const traj::TubeSolved solved = traj::solve_in_tube(task, way, rooms, {});
//   std::cout << (solved.why.empty() ? to_json_line(solved.solved.record) : solved.why);

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "traj/curve/yaw.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/record/flight_report.h"
#include "traj/record/solved_record.h"

namespace traj {

// What is asked of each path, and what flies.
struct TubeTask {
  SolveOptions solve;
  std::optional<YawOptions> yaw = {};
  VehicleProfile profile = {};
  FlightOptions flight = {};  // as prove_tube() needs them
  Disturbances disturbances = {};
};

// What the search may ask for.
struct TubeRooms {
  // The scene with this margin, in metres, around the vehicle of the path.
  std::function<std::shared_ptr<const geom::CollisionScene>(double margin)> scene;
  // Another path between the same ends in a scene. Empty: there is none.
  std::function<geom::PathRecord(const geom::CollisionScene& scene)> path;
};

inline constexpr int kMostTubeRounds = 6;

struct TubeRound {
  double margin = 0;    // m that the solver kept
  double largest = 0;   // m of the tube of what it found; 0: none was proved
  bool is_new = false;  // along a path of its own
  bool clear = false;   // the map, with that tube
};

struct TubeSolved {
  SolvedRecord solved;  // solved only where its own tube is clear
  FlightReport report;  // of the tube that was proved last; its radii are of `solved` or of none
  std::vector<TubeRound> rounds = {};
  std::string why = {};  // there is none, in words; empty: there is one
};

// Solves with the path's margin, proves the tube of the result, and asks whether the map is clear
// with that tube in place of any margin (check_tube(), at the tilt of the proof). If it is not, the
// next round keeps the largest radius as margin, and a twentieth more; where the legs are not free
// then, it takes another path. Each round proves the tube of its own trajectory: no radius of an
// earlier one counts. At most kMostTubeRounds. The trajectory never keeps less than the margin that
// the path was made with.
//
// A path that was not found has no trajectory and no rounds. The same for any number of threads.
TubeSolved solve_in_tube(const TubeTask& task, const geom::PathRecord& path, const TubeRooms& rooms,
                         const geom::Execution& run);

// "round 1: 0 m kept, tube 0.0312 m, touches; round 2: …".
std::string in_words(const std::vector<TubeRound>& rounds);

}  // namespace traj
