#include "tile_sort.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "base/radix_sort.h"
#include "base/spread_sort.h"
#include "geom/base/parallel.h"
#include "tile_order.h"

namespace geom {
namespace {

constexpr std::size_t kStretch = std::size_t{1} << 15;  // boxes that a thread takes at once

// The squares that small boxes are in, and a number for each of them: by row, then by column; 0 is
// the tile of large boxes.
struct Squares {
  static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  std::int32_t x0 = kMost, x1 = -kMost;
  std::int32_t y0 = kMost, y1 = -kMost;

  void add(const Place& place) {
    x0 = std::min(x0, place.ix), x1 = std::max(x1, place.ix);
    y0 = std::min(y0, place.iy), y1 = std::max(y1, place.iy);
  }
  void add(const Squares& other) {
    x0 = std::min(x0, other.x0), x1 = std::max(x1, other.x1);
    y0 = std::min(y0, other.y0), y1 = std::max(y1, other.y1);
  }
  bool empty() const { return x0 > x1; }
  std::uint64_t across() const { return static_cast<std::uint64_t>(std::int64_t{x1} - x0 + 1); }
  std::uint64_t last() const { return empty() ? 0 : number_of({true, y1, x1}); }

  std::uint64_t number_of(const Place& place) const {
    if (!place.small) return 0;
    const auto row = static_cast<std::uint64_t>(std::int64_t{place.iy} - y0);
    return 1 + row * across() + static_cast<std::uint64_t>(std::int64_t{place.ix} - x0);
  }
  Tile tile(std::uint64_t number) const {
    if (number == 0) return {0, 0, true, {}, 0, 0};
    const auto row = static_cast<std::int64_t>((number - 1) / across());
    const auto column = static_cast<std::int64_t>((number - 1) % across());
    return {static_cast<std::int32_t>(x0 + column),
            static_cast<std::int32_t>(y0 + row),
            false,
            {},
            0,
            0};
  }
};

// Calls f(stretch, begin, end) for stretches of n items, on all threads.
template <class F>
void for_stretches(std::size_t n, const Execution& run, const F& f) {
  parallel_for((n + kStretch - 1) / kStretch, {run.threads, {}},
               [&](std::size_t s) { f(s, s * kStretch, std::min(n, (s + 1) * kStretch)); });
}

Squares squares_of(const BoxTable& table, double size, const Execution& run) {
  const std::size_t n = table.boxes.size();
  std::vector<Squares> parts(n / kStretch + 1);
  for_stretches(n, run, [&](std::size_t s, std::size_t begin, std::size_t end) {
    Squares part;
    for (std::size_t i = begin; i < end; ++i) {
      const Place place = place_of(table.boxes[i], size);
      if (place.small) part.add(place);
    }
    parts[s] = part;
  });
  Squares all;
  for (const Squares& part : parts) all.add(part);
  return all;
}

// The boxes of the table by the number of their tile.
LargeArray<Keyed> by_tile(const BoxTable& table, double size, const Squares& squares,
                          const Execution& run) {
  LargeArray<Keyed> keyed(table.boxes.size());
  for_stretches(table.boxes.size(), run, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      keyed.all()[i] = {squares.number_of(place_of(table.boxes[i], size)), i};
    }
  });
  return radix_sorted(std::move(keyed), squares.last(), run);
}

std::vector<Tile> tiles_of(std::span<const Keyed> order, const Squares& squares) {
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].key != order[i - 1].key) {
      tiles.push_back(squares.tile(order[i].key));
      tiles.back().first = i;
    }
    ++tiles.back().count;
  }
  return tiles;
}

// Sorts the boxes of one tile: `order` is of these.
class TileSorter {
 public:
  explicit TileSorter(const BoxTable& table) : table_(table) {}

  void sort(std::span<Keyed> order) {
    placed_.clear();
    for (const Keyed& at : order) placed_.push_back({table_.boxes[at.item].min.x(), at.item});
    spread_sort(placed_, [&](const Placed& a, const Placed& b) {
      return a.x != b.x ? a.x < b.x : comes_first(a.box, b.box);
    });
    for (std::size_t i = 0; i < order.size(); ++i) order[i].item = placed_[i].box;
  }

 private:
  struct Placed {
    double x;  // its lower one
    std::size_t box;
  };

  bool comes_first(std::size_t a, std::size_t b) const {
    const Aabb& one = table_.boxes[a];
    const Aabb& other = table_.boxes[b];
    if (!(one == other)) return comes_before(one, other);
    if (table_.ids[a] != table_.ids[b]) return table_.ids[a] < table_.ids[b];
    if (const auto times = table_.time(a) <=> table_.time(b); times != 0) return times < 0;
    return a < b;
  }

  const BoxTable& table_;
  std::vector<Placed> placed_;
};

// Groups of tiles that follow each other, each of about a stretch of boxes: first tile of each, and
// the end.
std::vector<std::size_t> groups_of(std::span<const Tile> tiles) {
  std::vector<std::size_t> firsts;
  std::size_t next = 0;  // the box from which on a group begins
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].first < next) continue;
    firsts.push_back(t);
    next = tiles[t].first + kStretch;
  }
  firsts.push_back(tiles.size());
  return firsts;
}

// Writes the boxes of a tile to their places, and its extent.
void fill(Tile& tile, std::span<const Keyed> order, const BoxTable& table,
          BoxMap::Data::Owned& own) {
  tile.extent = canonical(table.boxes[order[tile.first].item]);
  for (std::size_t i = tile.first; i < tile.first + tile.count; ++i) {
    const std::size_t from = order[i].item;
    const Aabb box = canonical(table.boxes[from]);
    own.boxes.all()[i] = box;
    own.ids.all()[i] = table.ids[from];
    own.label.all()[i] = table.label[from];
    tile.extent = merged(tile.extent, box);
  }
}

void add_times(std::span<const Keyed> order, const BoxTable& table, BoxMap::Data::Owned& own) {
  if (table.times.empty()) return;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const TimeSpan time = canonical(table.time(order[i].item));
    if (time.always()) continue;
    own.timed.push_back(i);
    own.times.push_back(time);
  }
}

}  // namespace

SortedBoxes sorted_by_tile(const BoxTable& table, double tile_size, const Execution& run) {
  const Squares squares = squares_of(table, tile_size, run);
  LargeArray<Keyed> order = by_tile(table, tile_size, squares, run);
  std::vector<Tile> tiles = tiles_of(order.all(), squares);
  const auto own = std::make_shared<BoxMap::Data::Owned>(table.boxes.size());
  const std::vector<std::size_t> groups = groups_of(tiles);
  parallel_for(groups.size() - 1, {run.threads, {}}, [&](std::size_t g) {
    TileSorter sorter(table);
    for (std::size_t t = groups[g]; t < groups[g + 1]; ++t) {
      sorter.sort(order.all().subspan(tiles[t].first, tiles[t].count));
      fill(tiles[t], order.all(), table, *own);
    }
  });
  add_times(order.all(), table, *own);
  return {std::move(tiles), own};
}

}  // namespace geom
