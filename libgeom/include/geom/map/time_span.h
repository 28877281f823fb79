#pragma once

// The time during which an obstacle is there.
//
// Example:
//   const geom::TimeSpan half_an_hour{.from = 3600, .until = 5400};
//   assert(half_an_hour.meets({.from = 5400, .until = 6000}));  // closed at both ends
//   assert(geom::TimeSpan{}.always());

#include <compare>
#include <limits>
#include <optional>

#include "geom/base/error.h"

namespace geom {

// Closed, in seconds after the map's epoch: the obstacle is there at both ends. `from` may be
// -infinity and `until` infinity; both together are an obstacle that is always there.
struct TimeSpan {
  double from = -std::numeric_limits<double>::infinity();
  double until = std::numeric_limits<double>::infinity();

  bool always() const { return *this == TimeSpan{}; }
  // Whether the two have an instant in common; closed. False for NaN.
  bool meets(const TimeSpan& other) const { return from <= other.until && other.from <= until; }
  bool contains(const TimeSpan& other) const { return from <= other.from && other.until <= until; }

  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
  friend auto operator<=>(const TimeSpan&, const TimeSpan&) = default;
};

// Why the span is not valid: an end that is NaN, or beyond kLargestTime and not infinite;
// a `from` after `until`. Nothing if it is valid.
std::optional<Fault> span_fault(const TimeSpan& span);

}  // namespace geom
