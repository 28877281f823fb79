#pragma once

// check_pair() of flights whose joints are known.

#include <span>

#include "timeline.h"
#include "traj/together/pair_check.h"

namespace traj {

PairResult check_pair(const Timeline& a, const Timeline& b, std::span<const Zone> zones,
                      Parked parked);

}  // namespace traj
