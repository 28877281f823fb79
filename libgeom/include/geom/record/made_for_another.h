#pragma once

// Words for a record or file that was made for another map, vehicle or margin.
//
// Example:
//   const geom::Provenance ours = geom::provenance_of(scene);
//   geom::Provenance other = ours;
//   other.margin = 0;
//   assert(*geom::made_for_another(other, ours) == "made for another margin, 0 m, not 0.2 m");

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/record/record.h"

namespace geom {

// "made for another margin, 0 m, not 0.5 m", by the first in which the two differ: map, frame,
// vehicle, margin. Nothing where they agree.
std::optional<std::string> made_for_another(const Provenance& made_for, const Provenance& ours);

// Throws InputError(source, line, …) where a record that asks something says a map, frame, vehicle
// or margin, and it is not ours, or nobody says which is. What the record does not say counts as
// ours.
void require_asked_of(const Provenance& asked, const Provenance& ours, std::string_view source,
                      std::size_t line);

// "tello (half sizes 0.1, 0.1, 0.03 m)". Sizes have as many digits as people read, or `exact`, for
// where that would hide how two vehicles differ.
std::string in_words(const Vehicle& vehicle, bool exact);

}  // namespace geom
