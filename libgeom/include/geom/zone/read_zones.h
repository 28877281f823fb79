#pragma once

// Reads zones of airspace: EUROCAE ED-269 and ED-318, and the FAA's UAS facility maps.
//
// Example:
//   const std::string text = R"({"features":[{"identifier":"CH-1","country":"CHE",
//     "restriction":"PROHIBITED","applicability":[{"permanent":"YES"}],"geometry":[{
//     "uomDimensions":"M","lowerLimit":0,"lowerVerticalReference":"AGL","upperLimit":99999,
//     "upperVerticalReference":"AMSL","horizontalProjection":{"type":"Circle",
//     "center":[8.5,47.4],"radius":500}}]}]})";
//   const geom::ZoneFile file = geom::read_zones(text, "zones.json");
//   assert(file.format == "ed-269" && file.zones[0].volumes[0].outline.radius == 500);

#include <string_view>

#include "geom/base/format.h"
#include "geom/zone/zone.h"

namespace geom {

extern const Format kEd269Zones;
extern const Format kEd318Zones;
extern const Format kFaaFacilityMap;

// All of them.
Formats zone_formats();

// All zones of the file, at least one. Throws InputError(source, …), which names the zone, for
// whatever cannot be read whole: a type, unit, reference, day, event or geometry that is none of
// the format's, a limit without reference, limits that are inverted, times without an offset from
// UTC, ends before begins, rings of fewer than three places, holes whose edges cross, places that
// are not on Earth, edges of more than 1000 km, coordinates in another system than WGS 84.
//
// Read to the safe side, with a warning where people would want to know: a limit of 99999 or more
// is none; a limit or schedule that is null or absent is open; a ring whose edges cross stands for
// all that it encloses in any reading; a time to the minute (second) lasts to its end. A facility
// map gives two zones a cell: up to its ceiling one that needs an authorization, above it one that
// is closed.
ZoneFile read_zones(std::string_view text, std::string_view source);

}  // namespace geom
