#include "require_bounds.h"

#include <fmt/format.h>

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

}  // namespace geom
