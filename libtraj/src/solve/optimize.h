#pragma once

// The fastest smooth trajectory through a corridor: durations and joint states optimised at once.

#include <string>

#include "traj/curve/trajectory.h"
#include "traj/proof/limits.h"
#include "traj/solve/corridor.h"

namespace traj {

// banded: an interior point method of our own, linear in the number of pieces. ipopt: Ipopt with
// MUMPS, several times slower, which gets out of more corners.
enum class Optimizer { banded, ipopt };

struct OptimizeOptions {
  Limits limits;
  // Seconds of flight a unit of snap (m2/s7) is worth; on paths of l < 20 m times (l / 20 m)^2, as
  // snap grows without bound where the same curve is flown smaller with the same accelerations.
  double rho = 1e-3;
  int max_iterations = 200;  // of Ipopt; banded has five times as many
  Optimizer optimizer = Optimizer::ipopt;
  bool cruise = true;  // long straight legs: exactly straight at constant speed in their middle,
                       // and what lies between such legs is optimised part by part
};

struct OptimizeResult {
  Trajectory trajectory;               // one segment a piece; whatever the solver came back with
  std::string status = "was not run";  // the solver's word; never a proof
  bool settled = false;                // whether it ended because there was little left to gain
  bool cruises = false;                // whether a part of it is flown at constant speed
  int iterations = 0;                  // of parts, the most
  double objective = 0;                // duration + rho * integral of snap^2
  double max_violation = 0;  // of the constraints, in their own units: metres, squared ratios
};

// Minimises duration + rho * integral of snap^2 over trajectories of one segment a piece, at rest
// at both ends, continuous to jerk, whose Bernstein points are behind the planes of their piece and
// obey the limits. Tilt is a cone. The result need not be feasible: check it. A part that did not
// settle is in it too, so it leads from end to end in any case.
// The corridor has at least two pieces of positive length, pieces at its ends
// included. Threads may call at once; with Ipopt they wait for each other.
OptimizeResult optimize(const Corridor& corridor, const OptimizeOptions& options);

}  // namespace traj
