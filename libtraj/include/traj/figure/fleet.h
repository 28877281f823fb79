#pragma once

// A figure of many flights: how late they begin, how near they come, how many fly at once.
//
// Example:
//   const std::vector<traj::figure::FleetFlight> flights{{"a", 0, 10, 0.0}, {"b", 5, 10, 5.0}};
//   const std::string svg = traj::figure::fleet(flights, {.within = 20, .list = {}});
//   assert(svg.find("1 of 2 flights late") != std::string::npos);

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "traj/together/nearest_approach.h"

namespace traj::figure {

struct FleetFlight {
  std::string id;
  double start = 0;             // seconds after the epoch
  double duration = 0;          // seconds, >= 0
  std::optional<double> delay;  // seconds; where it is known when it was to begin
};

// An SVG of three panels: histograms of the delays and of the least distance of the pairs that come
// near each other, and the number of flights in the air over time. At least one flight.
// `approaches` are those of all flights.
std::string fleet(std::span<const FleetFlight> flights, const Approaches& approaches);

struct InTheAir {
  double time = 0;
  std::size_t flights = 0;  // from then on
};
// How many fly, in order of time: a flight does at its departure and no more at its arrival.
std::vector<InTheAir> in_the_air(std::span<const FleetFlight> flights);

}  // namespace traj::figure
