#pragma once

// What a cascade's loop does slowly in hover.

#include "tube/cascade_state.h"
#include "tube/error_set.h"

namespace traj {

// Linear forms of the deviations that the loop hardly mixes: the left eigenvectors of its slow
// modes, for each axis alone. `map` is that of `milliseconds` of hover with the heading `yaw`, in
// which the loops run in the same order again.
ErrorSetOf<CascadeRows>::Forms slow_modes(const ErrorMatrixOf<CascadeRows>& map, double yaw,
                                          double milliseconds);

}  // namespace traj
