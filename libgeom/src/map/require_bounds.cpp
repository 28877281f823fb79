#include "require_bounds.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"

namespace geom {

void require_bounds(const Aabb& bounds, std::string_view source) {
  // By its negation, which refuses NaN as well.
  if (!(bounds.min.array() < bounds.max.array()).all() ||
      !(bounds.min.cwiseAbs().maxCoeff() <= 2 * kLargestCoordinate) ||
      !(bounds.max.cwiseAbs().maxCoeff() <= 2 * kLargestCoordinate)) {
    const bool flat = bounds.min.z() == bounds.max.z();
    throw InputError(
        source, {.key = "the bounds",
                 .expected = "finite and have min < max on every axis",
                 .found = fmt::format("[{}, {}, {}] to [{}, {}, {}]", bounds.min[0], bounds.min[1],
                                      bounds.min[2], bounds.max[0], bounds.max[1], bounds.max[2]),
                 .advice = flat ? "all is flat, so give --ceiling, up to where flights go" : ""});
  }
}

bool is_within_reach(const Aabb& box) {
  return box.min.cwiseAbs().maxCoeff() <= kLargestCoordinate &&
         box.max.cwiseAbs().maxCoeff() <= kLargestCoordinate;
}

void require_within_reach(const BoxTable& table, std::string_view source) {
  const auto box = std::find_if_not(table.boxes.begin(), table.boxes.end(), is_within_reach);
  if (box == table.boxes.end()) return;
  throw InputError(
      source, {.says = fmt::format("expected boxes within 1e8 m of the origin, once "
                                   "scaled and grown; found box {} of the source from "
                                   "[{}, {}, {}] to [{}, {}, {}]",
                                   table.ids[static_cast<std::size_t>(box - table.boxes.begin())],
                                   box->min[0], box->min[1], box->min[2], box->max[0], box->max[1],
                                   box->max[2])});
}

}  // namespace geom
