#pragma once

// What is known of the ways home of flights, gathered from reports and planned ways.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/content/contents.h"
#include "svg.h"

namespace plot {

// What is known of the ways home of one flight.
struct HomeFlight {
  std::string id;
  std::vector<Point> height = {};                  // x: s of the flight; y: m; may be empty
  std::vector<traj::ReturnSummary> returns = {};   // of each report
  std::vector<traj::ContingencyRecord> ways = {};  // planned, ascending; may be empty
  double duration() const;                         // s, of all that
};

// Flights that have a report with returns, or planned ways, in the order in which they first come;
// with an `id` only that. One flight alone has the height of the trajectory of its id, else of the
// flight log.
std::vector<HomeFlight> home_flights(const cli::Contents& contents,
                                     const std::optional<std::string>& id = {});

// The times, s, from which there is a planned way with energy enough, as long as they go on.
// Ascending, apart.
std::vector<std::pair<double, double>> planned_times(
    const std::vector<traj::ContingencyRecord>& ways);

}  // namespace plot
