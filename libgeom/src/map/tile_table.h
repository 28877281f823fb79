#pragma once

// The tiles of a map, where they stand: in memory of its own, or in the arrays of a mapped file,
// which are not copied to open a map.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/base/once.h"
#include "geom/map/box_map.h"

namespace geom {

class TileTable {
 public:
  // One row a tile, as in the file (docs/formats.md).
  struct Columns {
    std::span<const std::int32_t> index;  // 2 each
    std::span<const std::uint8_t> large;
    std::span<const double> extent;        // 6 each
    std::span<const std::uint64_t> range;  // 2 each
  };

  TileTable() = default;
  void set(std::vector<Tile> tiles) { list_ = std::move(tiles); }
  void set(const Columns& columns) { columns_ = columns; }

  std::size_t size() const { return columns_.large.empty() ? list_.size() : columns_.large.size(); }

  Tile operator[](std::size_t t) const {
    if (columns_.large.empty()) return list_[t];
    const double* const e = &columns_.extent[6 * t];
    return {columns_.index[2 * t],  columns_.index[2 * t + 1],
            columns_.large[t] != 0, {{e[0], e[1], e[2]}, {e[3], e[4], e[5]}},
            columns_.range[2 * t],  columns_.range[2 * t + 1]};
  }

  // All of them in a row. Columns are copied when this is first asked for; threads may ask at once.
  std::span<const Tile> all() const {
    if (columns_.large.empty()) return list_;
    listed_.call([&] {
      std::vector<Tile> list;
      list.reserve(size());
      for (std::size_t t = 0; t < size(); ++t) list.push_back((*this)[t]);
      copied_ = std::move(list);
    });
    return copied_;
  }

 private:
  std::vector<Tile> list_;
  Columns columns_;
  mutable Once listed_;
  mutable std::vector<Tile> copied_;
};

}  // namespace geom
