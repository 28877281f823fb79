#pragma once

// When the sun rises and sets somewhere in an area, as bounds that hold the true instant.
//
// Example:
//   const geom::SunArea zurich{.south = 47.3, .north = 47.5, .west = 8.4, .east = 8.7};
//   const auto rise = geom::sun_time(geom::DayEvent::sunrise, 20576, zurich);  // 2026-05-03
//   assert(rise && rise->least < rise->most && rise->most - rise->least < 1500);

#include <cstdint>
#include <optional>

#include "geom/zone/zone.h"

namespace geom {

// Degrees; south <= north, and west <= east, which may be beyond 180.
struct SunArea {
  double south = 0;
  double north = 0;
  double west = 0;
  double east = 0;
};

struct SunTime {  // seconds since 1970-01-01T00:00:00Z
  double least = 0;
  double most = 0;
};

// The event on the day, counted from 1970-01-01, that has its noon by the sun of the area's middle.
// Nothing where the event may not come: the sun stays above or below all day somewhere.
//
// By the low-precision solar coordinates of the Astronomical Almanac (0.01 degrees between 1950 and
// 2050). The bounds are those of all places of the area, of heights of the sun half a degree above
// and below the event's (0.833 degrees below the level horizon, twilight 6), and two minutes more.
std::optional<SunTime> sun_time(DayEvent event, std::int64_t day, const SunArea& area);

}  // namespace geom
