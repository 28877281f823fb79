#pragma once

// A share of a map: its boxes or columns, and how all shares together become the map.
//
// Example:
//   geom::MapDraft draft{.source = "mine", .history = "[]"};
//   draft.table.add({{0, 0, 0}, {10, 10, 8}}, 1);
//   const geom::PartArrays arrays = geom::arrays_of(draft);  // for write_shard()

#include <span>

#include "geom/archive/shard_file.h"
#include "geom/map/column_grid.h"
#include "geom/map/map_draft.h"

namespace geom {

// A share of kind "boxes". Its arrays own their bytes but for the ids, which are the draft's.
PartArrays arrays_of(const MapDraft& draft);

// A share of kind "columns": columns in place of the draft's table.
PartArrays arrays_of(const MapDraft& draft, const ColumnGrid& columns, const ColumnSpec& spec);

// Whether shards of this kind make a map.
bool is_map_part(const ShardFile& shard);

// The map of all shards, in their order; throws InputError where they do not fit.
MadeMap join_map(std::span<const ShardFile> shards);

}  // namespace geom
