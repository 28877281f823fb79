#pragma once

// The planner's path before any search.

#include <optional>

#include "step.h"

namespace plan {

inline constexpr double kFarApart = 1500;  // metres between ends: from here on searches take long

struct FirstAnswer {
  Found found;
  Route route;
  bool is_taut = false;
};

// Over or round what stands on the straight line; by random trees where `fast` would get nothing
// better. Shortened for `fast`; pulled taut for the others, unless it is so long that a lattice
// will know better. None where there is none, and for a path that is to be raw. The ends do not see
// each other.
std::optional<FirstAnswer> first_answer(const geom::CollisionScene& scene, const Task& task);

// Whether it is so near to shortest that no lattice is asked: a search among bends finds what is
// left to gain. For `fast`, always.
bool suffices(const FirstAnswer& first, const Task& task);

}  // namespace plan
