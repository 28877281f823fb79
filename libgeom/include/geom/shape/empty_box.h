#pragma once

// The largest box without obstacles around a place.
//
// Example:
//   const std::vector<geom::Aabb> obstacles = {{{4, 0, 0}, {5, 8, 8}}};
//   const geom::Aabb limits{{0, 0, 0}, {10, 10, 10}};
//   const auto room = geom::empty_box({{1, 1, 1}, {1, 1, 1}}, limits, obstacles);
//   assert(room->box == (geom::Aabb{{0, 0, 0}, {4, 10, 10}}));

#include <optional>
#include <span>

#include "geom/shape/aabb.h"

namespace geom {

struct EmptyBox {
  Aabb box;
  bool largest = true;  // false where the search gave up and kept the best it had
};

// The box of largest volume inside `limits` that contains `seed` and whose interior meets none of
// the closed obstacles; nothing where `seed` meets one or is not inside `limits`. Exact by branch
// and bound (each obstacle inside is cut off at one of its faces), to `most_cuts` cuts. Ties go to
// the cut found first, so the answer depends on the order of the obstacles alone.
// InputError where an obstacle is inverted or not a number.
std::optional<EmptyBox> empty_box(const Aabb& seed, const Aabb& limits,
                                  std::span<const Aabb> obstacles, std::size_t most_cuts = 20000);

}  // namespace geom
