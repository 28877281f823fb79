#pragma once

// Times as whole numbers: where two flights' joints lie to each other is not rounded.

#include <cmath>
#include <cstdint>

#include "geom/base/rounding.h"

namespace traj {

// Of 2^-82 s. A double from 1e-9 to 1e9 is a whole number of them below 2^112, and so is the sum of
// a start and of durations that domain.h takes.
__extension__ using Ticks = __int128;

inline constexpr int kTickBits = 82;

// Exact for 0 and for sizes from 1e-9 to 1e9.
inline Ticks ticks_of(double seconds) {
  int exponent = 0;
  const double mantissa = std::frexp(seconds, &exponent);
  const auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int up = exponent - 53 + kTickBits;
  return static_cast<Ticks>(whole) * (static_cast<Ticks>(1) << up);
}

// Nearest, and not above or below.
inline double seconds_of(Ticks ticks) { return std::ldexp(static_cast<double>(ticks), -kTickBits); }
inline double seconds_below(Ticks ticks) { return geom::next_down(seconds_of(ticks)); }
inline double seconds_above(Ticks ticks) { return geom::next_up(seconds_of(ticks)); }

// The latest time that is not later and that ticks_of() takes, of any within 1e9 s.
inline double whole_time_below(double seconds) {
  constexpr double kLeast = 1e-9;
  if (seconds == 0 || std::abs(seconds) >= kLeast) return seconds;
  return seconds < 0 ? -kLeast : 0;
}

// The least double that is not below, where one is that near.
inline double seconds_not_below(Ticks ticks) {
  const double seconds = seconds_of(ticks);
  const bool exact = whole_time_below(seconds) == seconds && ticks_of(seconds) >= ticks;
  return exact ? seconds : geom::next_up(seconds);
}

// `part` / `whole`, relative to 3 * 2^-53; 0 <= part <= whole.
inline double ratio(Ticks part, Ticks whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace traj
