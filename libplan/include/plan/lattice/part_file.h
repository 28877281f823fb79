#pragma once

// Shards of lattices as JSON and NumPy arrays, for an archive of shards (docs/formats.md).
//
// Example:
//   const plan::LatticePart part = plan::build_lattice_part(scene, {.spacing = 1}, {0, 3});
//   const auto arrays = plan::arrays_of(part);
//   std::ostringstream out;
//   geom::write_array_archive(out, arrays.meta, arrays.arrays);

#include <string_view>

#include "geom/archive/shard_file.h"
#include "plan/lattice/lattice_part.h"

namespace plan {

using geom::PartArrays;

PartArrays arrays_of(const LatticePart& part);

// `meta_json` is that of PartArrays; the lattice refers to the archive's bytes. Throws
// geom::InputError where arrays don't fit each other.
LatticePart read_lattice_part(const geom::ArrayArchive& archive, std::string_view meta_json,
                              const geom::Shard& shard);

}  // namespace plan
