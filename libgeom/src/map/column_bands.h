#pragma once

// Columns as boxes: of cells side by side with equal heights, in bands of rows that threads share.

#include <span>
#include <string_view>

#include "column_shard.h"
#include "geom/base/execution.h"
#include "geom/map/column_grid.h"

namespace geom {

// A tile of columns, and the shard that holds their spans.
struct ColumnTile {
  const ColumnShard::Tiles::Tile* tile;
  const ColumnShard* shard;

  HeightSpans spans(int cell) const {
    return shard->spans_of(tile->cells[static_cast<std::size_t>(cell)]);
  }
};

// As ColumnGrid::boxes(); `tiles` by y, then x. The same for any number of threads.
BoxTable boxes_of_columns(std::span<const ColumnTile> tiles, const ColumnSpec& spec,
                          std::string_view source, const Execution& run);

}  // namespace geom
