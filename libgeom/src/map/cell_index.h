#pragma once

// Which cell or step of a grid a coordinate is in.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "geom/base/error.h"

namespace geom {

[[noreturn]] inline void refuse_index(double v, double size) {
  throw InputError(
      "column", {.expected = fmt::format("a coordinate within 2^31 cells or steps of {} m", size),
                 .found = fmt::to_string(v)});
}

// Near enough that the index of a cell or step beside it fits 31 bits, too.
inline double checked_index(double v, double size) {
  const double k = v / size;
  if (std::abs(k) < 0x1p31 - 2) return k;
  refuse_index(v, size);
}

inline void require_size(const char* what, double size) {
  if (size > 0 && std::isfinite(size)) return;
  throw InputError(what, {.expected = "metres > 0", .found = fmt::to_string(size)});
}

// The k with k * size <= v < (k + 1) * size as doubles multiply: division may be one off.
inline std::int32_t floor_index(double v, double size) {
  auto k = static_cast<std::int32_t>(checked_index(v, size));  // towards 0
  while (k * size > v) --k;
  while ((k + 1) * size <= v) ++k;
  return k;
}

inline std::int32_t ceil_index(double v, double size) {
  auto k = static_cast<std::int32_t>(checked_index(v, size));
  while (k * size < v) ++k;
  while ((k - 1) * size >= v) --k;
  return k;
}

}  // namespace geom
