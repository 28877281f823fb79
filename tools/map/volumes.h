#pragma once

// Volumes that a map is to keep vehicles out of, as boxes.

#include <string>

#include "cli/option/degrees.h"
#include "cli/run.h"
#include "geom/import/keep_out_boxes.h"

namespace verbs {

// Of GeoJSON, or of volumes of ASTM F3548. Warns of heights that the reader does not know.
geom::BoxTable keep_out(const std::string& path, const geom::BoxMapSpec& spec,
                        const geom::VolumeOptions& options, const cli::MetresOption& metres,
                        const cli::Common& common);

// What the fences of a mission's file forbid within the bounds: exclusions, and all outside of
// each inclusion.
geom::BoxTable fence(const std::string& path, const geom::BoxMapSpec& spec,
                     const geom::VolumeOptions& options);

}  // namespace verbs
