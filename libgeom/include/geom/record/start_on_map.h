#pragma once

// When a flight begins, by the clock of a map.
//
// Example:
//   const geom::FlightTime time{.epoch = "2026-05-04T06:30:00Z", .start = 60};
//   assert(!geom::start_on(map, time, "paths.jsonl", 1));  // this map has no timed boxes

#include <cstddef>
#include <optional>
#include <string_view>

#include "geom/map/box_map.h"
#include "geom/record/flight_time.h"

namespace geom {

// The `start` that the times of the map's boxes are held against, in seconds after the map's epoch.
// Nothing where the record says none, since `earliest` is only a wish, or where no box of the map
// has times: then all of them count as always there. Throws InputError(source, line, …) where both
// have an epoch and these differ, and where there would be a start but the record has no epoch.
std::optional<double> start_on(const BoxMap& map, const FlightTime& time, std::string_view source,
                               std::size_t line);

}  // namespace geom
