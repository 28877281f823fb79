#pragma once

// An interior point method for the optimiser's problem, whose matrix is block-tridiagonal: each
// iteration is linear in the number of pieces.

#include <string>
#include <vector>

#include "nlp.h"

namespace traj {

struct BandedOutcome {
  std::vector<double> x;  // where it ended, feasible or not
  std::string status = "was not run";
  int iterations = 0;
  bool settled = false;  // feasible to 1e-4, and little left to gain: as far as it can tell
};

// A primal-dual interior point method with slacks and a filter line search (Wächter and Biegler,
// On the implementation of an interior-point filter line-search algorithm, 2006; Nocedal and
// Wright, Numerical Optimization, chapter 19). Slacks and multipliers are eliminated, so what is
// factored has the variables alone. It is made positive definite by the durations: the states of a
// piece bend its Lagrangian upward, so that one number on the diagonal, the duration's, is enough.
//
// Only + - * / and square roots: the same bits on every x86-64. Threads may call at once.
BandedOutcome banded_solve(const Nlp& nlp, int max_iterations);

}  // namespace traj
