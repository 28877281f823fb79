#pragma once

// A value for each cell of a plane, in square tiles that are made on first touch.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

namespace geom {

// Tiles are found by a table of hashes (open addressing), so a cell costs the same wherever the
// last one was. Values begin as T().
template <class T>
class CellTiles {
 public:
  static constexpr int kSide = 16;  // cells

  struct Tile {
    std::int32_t x;  // in tiles
    std::int32_t y;
    std::unique_ptr<T[]> cells;  // row by row
  };

  // The reference stays good while other cells are touched.
  T& at(std::int32_t x, std::int32_t y) {
    const std::int32_t tx = tile_of(x);
    const std::int32_t ty = tile_of(y);
    if (last_ >= tiles_.size() || tiles_[last_].x != tx || tiles_[last_].y != ty) {
      last_ = find_or_make(tx, ty);
    }
    return tiles_[last_].cells[index(x - tx * kSide, y - ty * kSide)];
  }

  // Nothing where the cell's tile was never touched.
  const T* find(std::int32_t x, std::int32_t y) const {
    if (tiles_.empty()) return nullptr;
    const std::int32_t tx = tile_of(x);
    const std::int32_t ty = tile_of(y);
    const std::uint32_t slot = table_[slot_of(tx, ty)];
    if (slot == 0) return nullptr;
    return &tiles_[slot - 1].cells[index(x - tx * kSide, y - ty * kSide)];
  }

  std::size_t size() const { return tiles_.size(); }  // tiles that were made

  // By y, then x.
  std::vector<const Tile*> sorted() const {
    std::vector<const Tile*> out;
    for (const Tile& tile : tiles_) out.push_back(&tile);
    std::sort(out.begin(), out.end(), [](const Tile* a, const Tile* b) {
      return std::tie(a->y, a->x) < std::tie(b->y, b->x);
    });
    return out;
  }

 private:
  static std::int32_t tile_of(std::int32_t cell) { return cell >> 4; }  // rounds down
  static std::size_t index(std::int32_t x, std::int32_t y) {
    return static_cast<std::size_t>(y * kSide + x);
  }

  // Where the tile is in the table, or belongs.
  std::size_t slot_of(std::int32_t tx, std::int32_t ty) const {
    const std::uint64_t key =
        std::uint64_t{static_cast<std::uint32_t>(ty)} << 32 | static_cast<std::uint32_t>(tx);
    std::size_t slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32);
    for (;; ++slot) {
      slot &= table_.size() - 1;
      if (table_[slot] == 0) return slot;
      const Tile& tile = tiles_[table_[slot] - 1];
      if (tile.x == tx && tile.y == ty) return slot;
    }
  }

  std::size_t find_or_make(std::int32_t tx, std::int32_t ty) {
    if (2 * (tiles_.size() + 1) > table_.size()) grow();
    const std::size_t slot = slot_of(tx, ty);
    if (table_[slot] == 0) {
      tiles_.push_back({tx, ty, std::make_unique<T[]>(kSide * kSide)});
      table_[slot] = static_cast<std::uint32_t>(tiles_.size());
    }
    return table_[slot] - 1;
  }

  void grow() {
    table_.assign(std::max<std::size_t>(64, 2 * table_.size()), 0);
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      table_[slot_of(tiles_[i].x, tiles_[i].y)] = static_cast<std::uint32_t>(i + 1);
    }
  }

  static_assert(kSide == 1 << 4);
  std::vector<Tile> tiles_;
  std::vector<std::uint32_t> table_;  // a power of two; 1 + the index of a tile, 0 where none is
  std::size_t last_ = 0;              // the tile touched last
};

}  // namespace geom
