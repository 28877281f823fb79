#pragma once

// What was read, as the figures want it: paths that were found and trajectories that were solved.

#include <optional>
#include <string>
#include <vector>

#include "cli/content/contents.h"
#include "geom/figure/plan_view.h"
#include "traj/figure/clearance.h"
#include "traj/figure/home_flights.h"

namespace plot {

std::vector<geom::figure::PlanTree> plan_trees(const cli::Contents& contents, geom::Axes axes);
std::vector<geom::figure::PlanLine> plan_lines(const cli::Contents& contents, geom::Axes axes);

struct Tracks {
  std::vector<traj::figure::ClearanceTrack> list;
  std::string x_label;
};

// Trajectories and flights over time; paths over their length, where there are only those. What has
// no length in time or space is left out, and all of it on a map without obstacles.
Tracks tracks_of(const cli::Contents& contents, const geom::CollisionScene& scene);

geom::Provenance provenance_of(const cli::Contents& contents);  // of the first in tracks_of

// Flights that have a report with returns, or planned ways; with an `id` only that. One flight
// alone has the height of the trajectory of its id, else of the flight log.
std::vector<traj::figure::HomeFlight> home_flights(const cli::Contents& contents,
                                                   const std::optional<std::string>& id = {});

}  // namespace plot
