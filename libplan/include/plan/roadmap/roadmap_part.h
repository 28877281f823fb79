#pragma once

// A shard of a roadmap: what one of several processes builds.

#include <iosfwd>
#include <span>

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
