#pragma once

// Ipopt on our problem.

#include <string>
#include <vector>

#include "nlp.h"

namespace traj {

struct IpoptOutcome {
  std::vector<double> x;  // the start when the solver broke down
  std::string status = "was not run";
  int iterations = 0;
  bool settled = false;  // whether it ended because it was, nearly, at an optimum
};

// One at a time in a process: MUMPS crashes when two threads solve at once, so calls wait for each
// other. Prints nothing and reads no option file. Throws what the problem's functions throw, and
// std::bad_alloc where the solver's memory runs out.
IpoptOutcome ipopt_solve(const Nlp& nlp, int max_iterations);

}  // namespace traj
