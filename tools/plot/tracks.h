#pragma once

// What was read, as the plots want it: paths that were found and trajectories that were solved.

#include <string>
#include <vector>

#include "clearance.h"
#include "cli/content/contents.h"
#include "plan_view.h"

namespace plot {

std::vector<PlanTree> plan_trees(const cli::Contents& contents, geom::Axes axes);
std::vector<PlanLine> plan_lines(const cli::Contents& contents, geom::Axes axes);

struct Tracks {
  std::vector<ClearanceTrack> list;
  std::string x_label;
};

// Trajectories and flights over time; paths over their length, where there are only those. What has
// no length in time or space is left out, and all of it on a map without obstacles.
Tracks tracks_of(const cli::Contents& contents, const geom::CollisionScene& scene);

geom::Provenance provenance_of(const cli::Contents& contents);  // of the first in tracks_of

}  // namespace plot
