#pragma once

// A figure of the instants of a flight from which there is a way home.
//
// Example:
//   traj::figure::HomeFlight flight{.id = "q1"};
//   flight.ways = {{.id = "q1", .from = 0, .until = 5}};
//   assert(traj::figure::home(flight).starts_with("<svg"));

#include <span>
#include <string>

#include "traj/figure/home_flights.h"

namespace traj::figure {

// An SVG over the time of one flight: its height, a band for each report and one for planned ways,
// hollow where there is no way home, how long a planned way takes and how long there will still be
// one, and the reasons of the gaps in words.
std::string home(const HomeFlight& flight);

// An SVG of a row for each flight, the smallest share first: its band, shares and the least return
// height. Beyond 40 flights the first 40, and a histogram of all. At least one flight.
std::string homes(std::span<const HomeFlight> flights);

}  // namespace traj::figure
