#pragma once

// How far a piece's block is from positive definite, as its duration has it.

#include "nlp.h"

namespace traj {

// What is left on the diagonal of the duration when the piece's states are eliminated before it
// (the Schur complement). Where the states' own part is positive semidefinite, the block is
// positive semidefinite if and only if this is not negative. Rows and columns of 0 count as absent.
// The states' part is taken with a millionth added to its diagonal, or more where rounding makes
// that necessary.
double duration_pivot(const Nlp::Block& block);

}  // namespace traj
