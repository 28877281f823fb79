#pragma once

// Volumes that a map is to keep vehicles out of, as boxes.

#include <string>

#include "cli/option/degrees.h"
#include "cli/run.h"
#include "geom/import/keep_out_boxes.h"
#include "geom/map/map_patch.h"

namespace verbs {

// Of GeoJSON, or of volumes of ASTM F3548. Warns of heights that the reader does not know. Gives
// the number of boxes.
std::size_t patch_keep_out(const std::string& path, const geom::VolumeOptions& options,
                           const cli::MetresOption& metres, const cli::Common& common,
                           geom::MapPatch& patch);

// What the fences of a mission's file forbid within the bounds: exclusions, and all outside of
// each inclusion. Gives the number of boxes.
std::size_t patch_fence(const std::string& path, const geom::VolumeOptions& options,
                        geom::MapPatch& patch);

}  // namespace verbs
