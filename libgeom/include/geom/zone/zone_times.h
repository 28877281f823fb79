#pragma once

// When a zone is there, as spans of a map's time.
//
// Example:
//   const std::vector<geom::ZonePeriod> nights = {{.schedule = {{.begin = geom::DayTime{{}, 79200,
//   79200},
//                                                                .end = geom::DayTime{{}, 18000,
//                                                                18000}}}}};
//   const geom::ZoneClock clock{.epoch = "2026-05-04T00:00:00Z", .days = 2};
//   const std::vector<geom::TimeSpan> spans = geom::zone_times(nights, clock, {47, 47, 8, 8});
//   assert(!spans.empty());

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/map/time_span.h"
#include "geom/zone/sun_times.h"
#include "geom/zone/zone.h"

namespace geom {

struct ZoneClock {
  std::optional<std::string> epoch;  // as epoch_from() writes it; absent: nobody knows the time
  int days = 7;                      // schedules are worked out so many days before and after it
};

// Spans that hold all instants at which one of the periods is there, in order and apart. One that
// is always there for no periods, and without an epoch. Before and after the days that schedules
// are worked out for, a zone with a schedule is there all the time. Ends are rounded outward to
// what the file writes; events of the sun come as early or late as they may anywhere in the area.
// Days are those of UTC, and for events also those of the sun at the place; if an event may not
// come on a day, the zone is there all that day and the night on either side.
std::vector<TimeSpan> zone_times(std::span<const ZonePeriod> periods, const ZoneClock& clock,
                                 const SunArea& area);

}  // namespace geom
