#pragma once

// From which instants of flights there is a way home: the autopilot's return, and planned ways.

#include <span>
#include <string>

#include "home_flights.h"

namespace plot {

// An SVG over the time of one flight: its height, a band for each report and one for planned ways,
// hollow where there is no way home, how long a planned way takes and how long there will still be
// one, and the reasons of the gaps in words.
std::string home(const HomeFlight& flight);

// An SVG of a row for each flight, the smallest share first: its band, shares and the least return
// height. Beyond 40 flights the first 40, and a histogram of all. At least one flight.
std::string homes(std::span<const HomeFlight> flights);

}  // namespace plot
