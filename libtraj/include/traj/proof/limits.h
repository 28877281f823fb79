#pragma once

// The limits of a flight, by the names that this library uses: they are those of geom::Vehicle.

#include "geom/vehicle/limits.h"

namespace traj {

using geom::kGravity;
using geom::kLimitFields;
using geom::LimitField;
using geom::Limits;

}  // namespace traj
