#pragma once

// The columns of some of the cells: what one thread fills at a time.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cell_tiles.h"

namespace geom {

// Of heights, in steps: closed.
struct HeightSpan {
  std::int32_t low;
  std::int32_t high;

  friend bool operator==(const HeightSpan&, const HeightSpan&) = default;
};
using HeightSpans = std::span<const HeightSpan>;  // ascending, further apart than the gap

// A span on its way into the column of its cell.
struct CellSpan {
  std::int32_t x;
  std::int32_t y;
  HeightSpan span;
};

class ColumnShard {
 public:
  // The spans of a cell: a few in place, more in a list of their own. A lone return takes 6 KiB, as
  // cells stand in tiles.
  struct Column {
    // Holds no other span.
    static constexpr HeightSpan kNone{std::numeric_limits<std::int32_t>::max(),
                                      std::numeric_limits<std::int32_t>::min()};
    std::uint32_t count = 0;
    std::uint32_t list = 0;  // 1 + the index of its list, where it ever had one
    std::array<HeightSpan, 2> few{kNone, kNone};  // those there were last, where there is a list
  };
  using Tiles = CellTiles<Column>;

  // Joins each with the spans of its cell that are no further from it than the gap (steps).
  void add(std::span<const CellSpan> spans, std::int64_t gap);

  HeightSpans spans_of(const Column& column) const {
    if (column.count <= column.few.size()) return {column.few.data(), column.count};
    return lists_[column.list - 1];
  }
  const Tiles& tiles() const { return tiles_; }

 private:
  void settle(Column& column, const HeightSpan& span, std::int64_t gap);
  void merge_into(Column& column, const HeightSpan& span, std::int64_t gap);

  Tiles tiles_;
  std::vector<std::vector<HeightSpan>> lists_;
  std::vector<HeightSpan> merged_;  // of the column that changes
};

}  // namespace geom
