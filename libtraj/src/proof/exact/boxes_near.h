#pragma once

// The boxes of a map near each of many regions. The exact check has this search of its own, because
// it shares no index with the check that it confirms.

#include <cstddef>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace traj::exact {

// For each region the indices of all boxes that meet it once they are `reach` metres larger on
// every side, in ascending order; boxes that miss it by rounding may be among them. Regions that
// follow one another should lie near one another: then it costs little more than one look at every
// box.
std::vector<std::vector<std::size_t>> boxes_near(std::span<const geom::Aabb> boxes,
                                                 const geom::Vec3& reach,
                                                 std::span<const geom::Aabb> regions);

}  // namespace traj::exact
