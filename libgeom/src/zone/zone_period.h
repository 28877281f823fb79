#pragma once

// When a zone is there, as ED-269 and ED-318 say it.

#include <string>
#include <vector>

#include "zone_fields.h"

namespace geom::zone {

// The periods of a list, which may be null; none where the zone is always there. Times of day stand
// in `schedule`, in `dailyPeriod`, or in both, and each of them counts. A member that is not known
// may say that the zone is there at other times, too: its period, or its time of day, is always.
// Adds a warning of each. Throws InputError for what cannot be read.
std::vector<ZonePeriod> periods_of(const Json* list, const char* key, const ZonePlace& place,
                                   std::vector<std::string>& warnings);

}  // namespace geom::zone
