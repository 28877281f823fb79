#include "tile_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/precondition.h"

namespace geom {
namespace {

constexpr double kOneGroup = 16;  // times as many boxes as wanted are one group still

// Takes tiles one after the other: row after row, and in a row from left to right.
class Grouping {
 public:
  Grouping(std::int32_t side, TileGroups& out) : side_(side), out_(out) {}

  void add(const Tile& tile) {
    const bool begins = out_.runs.empty();
    if (begins || tile.iy != row_ || tile.ix > last_x_ || tile.large != large_) turn_to(tile);
    if (begins || !band_[place_].open || too_far(tile)) {
      band_[place_].group = new_group(tile);
      band_[place_].open = true;
    }
    const std::uint32_t group = band_[place_].group;
    Aabb& extent = out_.extent[group];
    for (int k = 0; k < 3; ++k) {  // number by number, as they are read
      extent.min[k] = std::min(extent.min[k], tile.extent.min[k]);
      extent.max[k] = std::max(extent.max[k], tile.extent.max[k]);
    }
    add_run(group, tile);
  }

 private:
  // A square of this row of squares. Nothing is in it before its first tile.
  struct Square {
    std::int32_t x;
    std::uint32_t group;
    bool open;
  };

  // Which square, of so many tiles a side, a tile's column or row is in.
  std::int32_t square(std::int32_t i) const { return i >= 0 ? i / side_ : -1 - (-1 - i) / side_; }

  // Makes the tile's square the one at place_, and stays in it up to last_x_.
  void turn_to(const Tile& tile) {
    const std::int32_t y = side_ > 0 ? square(tile.iy) : 0;
    const std::int32_t x = side_ > 0 ? square(tile.ix) : 0;
    if (out_.runs.empty() || y != band_y_ || (tile.large != large_ && side_ > 0)) {
      band_.clear();
      place_ = 0;
    } else if (tile.iy != row_) {
      place_ = 0;
    }
    band_y_ = y;
    row_ = tile.iy;
    large_ = tile.large;
    const std::int64_t last =
        side_ > 0 ? (std::int64_t{x} + 1) * side_ - 1 : std::numeric_limits<std::int32_t>::max();
    last_x_ = static_cast<std::int32_t>(
        std::min<std::int64_t>(last, std::numeric_limits<std::int32_t>::max()));
    while (place_ < band_.size() && band_[place_].x < x) ++place_;
    if (place_ == band_.size() || band_[place_].x != x) {
      band_.insert(band_.begin() + static_cast<std::ptrdiff_t>(place_), {x, 0, false});
    }
  }

  // Whether the tile's boxes have no name in the group.
  bool too_far(const Tile& tile) const {
    const std::size_t first = out_.runs[out_.head[band_[place_].group]].first;
    return tile.first + tile.count - first >= TileGroups::kMostNames;
  }

  std::uint32_t new_group(const Tile& tile) {
    out_.head.push_back(TileGroups::kEnd);
    out_.extent.push_back(tile.extent);
    tail_.push_back(TileGroups::kEnd);
    return static_cast<std::uint32_t>(out_.head.size() - 1);
  }

  void add_run(std::uint32_t group, const Tile& tile) {
    std::uint32_t& tail = tail_[group];
    const auto next = static_cast<std::uint32_t>(out_.runs.size());
    if (tail != TileGroups::kEnd && tail + 1 == next) {
      out_.runs[tail].count += static_cast<std::uint32_t>(tile.count);  // its boxes come next
      return;
    }
    (tail == TileGroups::kEnd ? out_.head[group] : out_.runs[tail].next) = next;
    out_.runs.push_back({tile.first, static_cast<std::uint32_t>(tile.count), TileGroups::kEnd});
    tail = next;
  }

  std::int32_t side_;  // tiles; 0: one group
  TileGroups& out_;
  std::vector<std::uint32_t> tail_;  // of each group, the last run
  std::vector<Square> band_;         // of this row of squares, from left to right
  std::size_t place_ = 0;            // in band_
  std::int32_t band_y_ = 0;
  std::int32_t row_ = 0;
  std::int32_t last_x_ = 0;  // column of the last tile that the square may have
  bool large_ = false;
};

}  // namespace

TileGroups tile_groups(const TileTable& tiles, std::size_t boxes, double wanted) {
  std::int32_t side = 0;
  if (static_cast<double>(boxes) > kOneGroup * wanted) {
    const double share = wanted * static_cast<double>(tiles.size()) / static_cast<double>(boxes);
    side = static_cast<std::int32_t>(std::max(1.0, std::ceil(std::sqrt(share))));
  }
  TileGroups out;
  const auto squares = tiles.size() / static_cast<std::size_t>(std::max(1, side * side));
  out.extent.reserve(squares + squares / 16);
  out.runs.reserve(tiles.size() / static_cast<std::size_t>(std::max(1, side)));
  Grouping grouping(side, out);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const Tile tile = tiles[t];
    require_point("box map", tile.extent.min);
    require_point("box map", tile.extent.max);
    grouping.add(tile);
  }
  return out;
}

}  // namespace geom
