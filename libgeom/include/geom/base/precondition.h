#pragma once

// Checks of the arguments of public functions.
//
// Example:
//   const geom::Vec3 p(1, 2, 3);
//   geom::require_point("the start", p);        // InputError for NaN, or beyond kFarthest
//   geom::require_length("radius", 2.5, 1000);  // InputError below 0 or above 1000

#include <cmath>
#include <string_view>

#include "geom/base/vec3.h"

namespace geom {

// How far out a point may be asked about, in metres: past every map (kLargestCoordinate) and
// whatever is grown around it, and near enough that no difference or square overflows.
inline constexpr double kFarthest = 10 * kLargestCoordinate;

[[noreturn]] void refuse_point(std::string_view what, const Vec3& p);
[[noreturn]] void refuse_length(std::string_view what, double value, double most);

// Each throws InputError("`what`", …) for a wrong argument, NaN included. It costs a few
// comparisons.

// A point must have finite coordinates within kFarthest.
inline void require_point(std::string_view what, const Vec3& p) {
  if (std::abs(p[0]) <= kFarthest && std::abs(p[1]) <= kFarthest && std::abs(p[2]) <= kFarthest) {
    return;
  }
  refuse_point(what, p);
}

// require_point() of both, in few operations for points near the origin.
inline void require_points(std::string_view what, const Vec3& a, const Vec3& b) {
  if (a.lpNorm<1>() + b.lpNorm<1>() <= kFarthest) return;
  require_point(what, a);
  require_point(what, b);
}

// A length must be from 0 to `most`, metres.
inline void require_length(std::string_view what, double value, double most) {
  if (!(value >= 0 && value <= most)) refuse_length(what, value, most);
}

}  // namespace geom
