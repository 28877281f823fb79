#pragma once

// Shards of roadmaps as JSON and NumPy arrays, for an archive that says what they are shards of
// (docs/formats.md).

#include <string_view>

#include "plan/lattice/part_file.h"
#include "plan/roadmap/roadmap_part.h"

namespace plan {

PartArrays arrays_of(const RoadmapPart& part);

// `meta_json` is that of PartArrays; the edges refer to the archive's bytes. Throws
// geom::InputError where arrays don't fit each other.
RoadmapPart read_roadmap_part(const geom::ArrayArchive& archive, std::string_view meta_json,
                              const geom::Shard& shard);

}  // namespace plan
