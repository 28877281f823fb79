#pragma once

// From a free path to a proved trajectory: the ladder of solvers.
//
// Example:
//   const traj::SolveResult flight = traj::solve(scene, path, {.limits = limits});
//   if (flight.status == traj::SolveStatus::solved) {
//     std::cout << traj::duration(flight.trajectory) << " s, " << traj::name(*flight.rung) << '\n';
//   }

#include <optional>
#include <span>
#include <string>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"
#include "traj/solve/closed_form.h"
#include "traj/solve/corridor.h"
#include "traj/solve/min_snap.h"
#include "traj/solve/rung.h"

namespace traj {

// automatic: the closed form where it is proved and nearly as fast as the limits allow, else the
// optimisers (banded, and where that does not end well ipopt) where the result is proved and no
// slower than stop-and-go, else whichever of closed form and stop-and-go is proved and faster. The
// others try that one alone.
enum class Solver { automatic, closed, banded, ipopt, stop_and_go };

// What keeps the optimiser off the obstacles first: a plane for each near a piece, or the faces of
// empty boxes along the path. Where one ends in no proof, the other is tried.
enum class CorridorKind { planes, boxes };

struct SolveOptions {
  Limits limits;
  Solver solver = Solver::automatic;
  double rho = 1e-3;         // seconds of flight a unit of snap (m2/s7) is worth
  int max_iterations = 200;  // of Ipopt, each round; banded has five times as many
  CorridorKind corridor = CorridorKind::planes;
  std::optional<Times> times;  // of the closed form, which automatic then takes wherever it is
                               // proved; absent: stops
};

enum class SolveStatus { solved, infeasible };

struct SolveResult {
  SolveStatus status = SolveStatus::infeasible;
  std::string reason;         // why not, in words; empty when solved
  Trajectory trajectory;      // empty unless solved
  std::optional<Rung> rung;   // absent unless solved
  std::string solver_status;  // the optimiser's own word, "was not run" before it runs
  int iterations = 0;         // of the optimiser, all rounds
  int rounds = 0;             // of the optimiser
  int proofs = 0;             // proofs tried, of these rounds and of other candidates
  double objective = 0;       // of its last round
  double max_violation = 0;   // the largest constraint violation of its last round
  Corridor corridor;          // of its last round; empty when it was not run
  double snap = 0;            // integral of |fourth derivative|^2 of the result, m2/s7
};

// Every solved result has passed traj::check for these limits. Every path whose legs are
// free and inside the bounds is solved by `automatic`. Ipopt runs once at a time in a process
// (MUMPS is not thread safe); threads that call this wait for each other there.
SolveResult solve(const geom::CollisionScene& scene, const geom::Polyline& path,
                  const SolveOptions& options);

// The same with holds and given velocities (accelerations and jerks are ignored). The path is
// solved in parts from hold to hold, and `rung` is the lowest of theirs; the figures from
// iterations on are sums and, from objective on, the worst. A part with given velocities has the
// closed form only.
SolveResult solve(const geom::CollisionScene& scene, std::span<const Waypoint> waypoints,
                  const SolveOptions& options);

}  // namespace traj
