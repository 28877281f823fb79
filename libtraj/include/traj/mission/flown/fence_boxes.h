#pragma once

// Fences of a mission as boxes of a map, from its bottom to its top.
//
// Example, not run:
//   std::ifstream in("fenced.plan");
//   const std::vector<traj::GeodeticFence> fences = traj::read_fences(in, "fenced.plan");
//   const geom::BoxTable boxes = traj::fence_boxes(fences, "fenced.plan", map.spec());

#include <span>
#include <string>

#include "geom/import/keep_out_boxes.h"
#include "traj/mission/flown/fence.h"

namespace traj {

// Boxes that hold all that the fences forbid within the bounds of the map: exclusions, and all
// outside of each inclusion. Their label is "fence", and their id the number of the fence. Of the
// options, `slack` and `far` hold. Throws UsageError if the map has no origin on Earth,
// InputError(source, …) as fence_on_map() and geom::keep_out_boxes() do.
geom::BoxTable fence_boxes(std::span<const GeodeticFence> fences, const std::string& source,
                           const geom::BoxMapSpec& spec, const geom::VolumeOptions& options = {});

// Throws that UsageError, before a file of fences is read.
void require_place_for_fences(const geom::BoxMapSpec& spec);

}  // namespace traj
