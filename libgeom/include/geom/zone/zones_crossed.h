#pragma once

// Which zones of airspace a flight is in, and when.
//
// Example:
//   geom::BoxMapSpec spec{.bounds = {{-50, -50, 0}, {50, 50, 100}}};
//   spec.frame.origin = geom::GeodeticOrigin{47.4, 8.5, 0};
//   spec.epoch = "2026-05-04T06:00:00Z";
//   geom::ZoneFile file;
//   file.zones.emplace_back().volumes.emplace_back().outline.centre = {47.4, 8.5, 0};
//   file.zones[0].volumes[0].outline.radius = 20;
//   const std::vector<geom::PlacedTime> flight = {{{{-30, 0, 10}, {30, 1, 20}}, {0, 60}}};
//   const auto crossed = geom::zones_crossed(file, "zones.json", {.spec = spec}, flight);
//   assert(crossed.size() == 1 && crossed[0].index == 0);

#include <span>
#include <string>
#include <vector>

#include "geom/zone/zone_boxes.h"

namespace geom {

// A box that holds a vehicle for a time, in the map's coordinates and seconds after its epoch.
struct PlacedTime {
  Aabb room;
  TimeSpan time;
};

struct CrossedZone {
  std::size_t index = 0;  // in the file
  TimeSpan time;          // from the first to the last instant at which the flight may be in it
};

// The zones that the flight may be in, of all types, in the order of the file. No zone that the
// flight enters is missing. Unknown heights and times count as in zone_boxes(). Throws InputError
// as zone_boxes() does, and if a part of the flight is outside the bounds of the map.
std::vector<CrossedZone> zones_crossed(const ZoneFile& file, const std::string& source,
                                       ZoneRoom room, std::span<const PlacedTime> flight);

}  // namespace geom
