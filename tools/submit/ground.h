#pragma once

// --ground-model: the ground below missions above terrain, as a file of the folder.

#include <optional>

#include "cli/content/terrain_option.h"
#include "geom/map/box_map.h"
#include "geom/map/ground_model.h"
#include "submission_folder.h"
#include "traj/submit/submission.h"

namespace submitting {

// Adds the file to the folder, and its name, its hash and the terrain's error to the method.
// Returns the ground as the folder has it, or nothing without the option. Throws
// geom::InputError for the ground of another map.
std::optional<geom::GroundModel> take_ground(const cli::TerrainOption& option,
                                             const geom::BoxMap& map,
                                             traj::SubmissionMethod& method,
                                             SubmissionFolder& folder);

// The floor of the map, or the lowest ground over the map where that is lower.
double floor_over(const geom::GroundModel& ground, const geom::Aabb& bounds);

}  // namespace submitting
