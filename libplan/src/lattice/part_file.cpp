#include "plan/lattice/part_file.h"

#include "block_store.h"
#include "geom/text/json_fields.h"
#include "plan/lattice/lattice_file.h"

namespace plan {

PartArrays arrays_of(const LatticePart& part) {
  return {lattice_meta({part.grid, part.blocks.counts, part.made_for}),
          block_arrays(part.grid, part.blocks.record, {part.blocks.records}),
          {}};
}

LatticePart read_lattice_part(const geom::ArrayArchive& archive, std::string_view meta_json,
                              const geom::Shard& shard) {
  const LatticeMeta meta = read_lattice_meta(geom::JsonFields(meta_json, archive.name(), 0));
  return {meta.grid, meta.made_for, shard, read_blocks(archive, meta.grid, meta.counts)};
}

}  // namespace plan
