#pragma once

// The boxes that a path may meet which is shorter than a given length.

#include <cstddef>
#include <optional>
#include <vector>

#include "geom/collision/collision.h"
#include "short_ways.h"

namespace plan {

// Indices, ascending, of boxes among which are all whose grown boxes the ways meet, and few others.
// Nothing where these are more than `most`, which costs no more than finding about so many.
std::optional<std::vector<std::size_t>> boxes_within(const geom::CollisionScene& scene,
                                                     const ShortWays& ways, std::size_t most);

}  // namespace plan
