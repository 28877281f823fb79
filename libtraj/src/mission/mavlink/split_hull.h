#pragma once

// Convex regions cut into pieces that are no wider than they may be.

#include <vector>

#include "mission/flown/flown_regions.h"

namespace traj {

// Hulls that together hold the hull, each no longer than `most` metres (> 0) along x and along y. A
// piece that would have many points is the box around it.
std::vector<Hull> split_hull(const Hull& hull, double most);

}  // namespace traj
