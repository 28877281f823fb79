#pragma once

// Whether the plan of a building shows a place where nothing else of it stands.

#include <vector>

#include "geom/import/city_model.h"

namespace geom {

using CitySurfaces = std::vector<const CitySurface*>;

// How wide a place may be that the surfaces of a building leave out of its plan, in the model's
// units: outlines of two levels of detail, or of a plan and the parts on it, never agree quite.
inline constexpr double kWidestSliver = 1;

// Whether a circle fits into what `surfaces` leave out of `plan`, seen from above, whose diameter
// is `kWidestSliver`, or a seventh of the plan's length where that is less. No such circle is
// missed. A strip along a side that is narrower than a third of that is no gap.
bool has_gap(const CitySurfaces& plan, const CitySurfaces& surfaces);

}  // namespace geom
