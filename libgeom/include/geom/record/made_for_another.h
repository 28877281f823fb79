#pragma once

// Words for a record or file that was made for another map, vehicle or margin, and for limits.

#include <optional>
#include <string>

#include "geom/record/record.h"

namespace geom {

// "made for another margin, 0 m, not 0.5 m", by the first in which the two differ: map, frame,
// vehicle, margin. Nothing where they agree.
std::optional<std::string> made_for_another(const Provenance& made_for, const Provenance& ours);

// "tello (half sizes 0.1, 0.1, 0.03 m)". Sizes have as many digits as people read, or `exact`, for
// where that would hide how two vehicles differ.
std::string in_words(const Vehicle& vehicle, bool exact);

// A limit in the unit of its option: "12 m/s", "35 degrees".
std::string in_words(const LimitKind& kind, double value);

}  // namespace geom
