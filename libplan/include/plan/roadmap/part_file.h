#pragma once

// Shards of roadmaps as JSON and NumPy arrays, for an archive of shards (docs/formats.md).
//
// Example:
//   const plan::Roadmap part = plan::build_roadmap_part(scene, {}, {.index = 0, .count = 3});
//   const plan::PartArrays arrays = plan::arrays_of(part);
//   std::ostringstream out;
//   geom::write_array_archive(out, arrays.meta, arrays.arrays);

#include <string_view>

#include "plan/lattice/part_file.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// The arrays refer to the part, which must outlive them.
PartArrays arrays_of(const Roadmap& part);

// `meta_json` is that of PartArrays; the roadmap refers to the archive's bytes. Throws
// geom::InputError where arrays don't fit each other.
Roadmap read_roadmap_part(const geom::ArrayArchive& archive, std::string_view meta_json);

}  // namespace plan
