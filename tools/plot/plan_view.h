#pragma once

// The city from above, with paths.

#include <span>
#include <string>

#include "geom/box_map.h"
#include "geom/io/record.h"

namespace plot {

// An SVG of the map in east-north axes: obstacles shaded by the height of their top, paths on it.
std::string plan_view(const geom::BoxMap& map, std::span<const geom::PathRecord> paths);

}  // namespace plot
