#pragma once

// What of a cascade's commands may be clipped, within bounds.

#include <functional>
#include <optional>

#include "traj/tube/prove_tube.h"
#include "tube/cascade_step.h"

namespace traj {

// The first command of a period that may reach its limit, the times counted from the period's
// start. `radius` bounds how far a quantity may be from its middle.
std::optional<TubeTrouble> first_clip(
    const CascadeLoop& loop, const CascadeStep<CascadeRows::Model>& step,
    const std::function<double(const CascadeRows::Model&)>& radius);

}  // namespace traj
