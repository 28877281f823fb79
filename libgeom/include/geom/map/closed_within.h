#pragma once

// The part of a map in which zones, fences and the like are closed.
//
// Example:
//   assert(!geom::closed_within(map.spec()));  // this map has no zones

#include <optional>

#include "geom/map/box_map.h"

namespace geom {

// Zones of airspace, limits over the ground, fences, and keep-out volumes without an altitude were
// cut to the bounds that the map had then, so bounds may not reach beyond this box. By the map's
// history: the bounds at each such step, cut by what was cropped since. Nothing where there was no
// such step.
std::optional<Aabb> closed_within(const BoxMapSpec& spec);

// Throws InputError(source, …) where `bounds` reach beyond it.
void require_closed_within(const BoxMapSpec& spec, const Aabb& bounds, const std::string& source);

}  // namespace geom
