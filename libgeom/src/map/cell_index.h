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

inline void require_size(const char* what, double size) {
  if (size > 0 && std::isfinite(size)) return;
  throw InputError(what, {.expected = "metres > 0", .found = fmt::to_string(size)});
}

// The cells or steps of one size (> 0, finite): number k holds from k * size to below (k + 1) *
// size, as doubles multiply. The product with 1 / size may give an index that is off by one. Then
// it is corrected.
class CellIndex {
 public:
  explicit CellIndex(double size) : size_(size), inverse_(1 / size) {}

  // The k that holds v.
  std::int32_t floor(double v) const {
    std::int32_t k = guess(v);
    while (k * size_ > v) --k;
    while ((k + 1) * size_ <= v) ++k;
    return k;
  }

  // The least k with v <= k * size.
  std::int32_t ceil(double v) const {
    std::int32_t k = guess(v);
    while (k * size_ < v) ++k;
    while ((k - 1) * size_ >= v) --k;
    return k;
  }

 private:
  // Near enough that the index of a cell or step beside it fits 31 bits, too.
  std::int32_t guess(double v) const {
    const double at = v * inverse_;
    if (!(std::abs(at) < 0x1p31 - 2)) refuse_index(v, size_);
    const auto towards_0 = static_cast<std::int32_t>(at);
    return towards_0 - static_cast<std::int32_t>(at < towards_0);
  }

  double size_;
  double inverse_;
};

}  // namespace geom
