#pragma once

// The limits of a flight, by the names that this library uses.
//
// Example:
//   const traj::Limits slow{{traj::Limit::speed, 5}};
//   for (const traj::Limit limit : traj::kOrderOfLimits) {
//     if (slow[limit]) std::cout << traj::kind_of(limit).quantity << '\n';
//   }
//
// They are those of geom::Vehicle.

#include "geom/vehicle/limits.h"

namespace traj {

using geom::kGravity;
using geom::kind_of;
using geom::kLimitKinds;
using geom::kOrderOfLimits;
using geom::Limit;
using geom::LimitKind;
using geom::Limits;
using geom::PerLimit;

}  // namespace traj
