#pragma once

// A shard of a roadmap: what one of several processes builds.
//
// Example:
//   std::vector<plan::Roadmap> parts;
//   for (std::size_t i = 0; i < 3; ++i) {  // each in a process of its own
//     parts.push_back(plan::build_roadmap_part(scene, {}, {.index = i, .count = 3}));
//   }
//   std::ostringstream out;
//   plan::write_roadmap(out, parts);  // bit for bit what one process writes

#include <iosfwd>

#include "geom/base/execution.h"
#include "geom/base/shard.h"
#include "geom/collision/collision.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// The tiles of build_roadmap() that are the shard's, a run of them: bit for bit as they are there.
// Only boxes within reach of its own are looked at.
Roadmap build_roadmap_part(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                           const geom::Shard& shard, const geom::Execution& run = {});

}  // namespace plan
