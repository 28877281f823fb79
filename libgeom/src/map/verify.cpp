#include "verify.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"
#include "hash.h"
#include "tile_order.h"

namespace geom {
namespace {

constexpr std::size_t kStretch = std::size_t{1} << 16;  // boxes that a thread looks at in a row
constexpr std::string_view kAdvice =
    "the file is damaged, or says what is not so: get it again, or make the map anew";

std::string shown(const Aabb& box) {
  return fmt::format("[{}, {}, {}] to [{}, {}, {}]", box.min[0], box.min[1], box.min[2], box.max[0],
                     box.max[1], box.max[2]);
}

[[noreturn]] void refuse(const BoxMap::Data& data, Fault fault) {
  fault.advice = kAdvice;
  throw InputError(data.archive->name(), std::move(fault));
}

// Calls f(tile, begin, end) for stretches of boxes of one tile, on all threads.
template <class F>
void for_each_stretch_of_tiles(const BoxMap::Data& data, const Execution& run, const F& f) {
  const std::size_t n = data.boxes.size();
  const std::span<const Tile> tiles = data.tiles.all();
  parallel_for((n + kStretch - 1) / kStretch, {run.threads, {}}, [&](std::size_t item) {
    std::size_t at = item * kStretch;
    const std::size_t end = std::min(n, at + kStretch);
    read_ahead(std::as_bytes(data.boxes.subspan(at, end - at)));
    const auto after =
        std::upper_bound(tiles.begin(), tiles.end(), at,
                         [](std::size_t box, const Tile& tile) { return box < tile.first; });
    for (auto t = static_cast<std::size_t>(after - tiles.begin()) - 1; at < end; ++t) {
      const std::size_t last = std::min(end, tiles[t].first + tiles[t].count);
      f(t, at, last);
      at = last;
    }
    trim_mapped_files();
  });
}

// All comparisons, so that they need no branches; false for NaN.
bool is_ordered_inside(const Aabb& box, const Aabb& extent) {
  bool ok = true;
  for (int k = 0; k < 3; ++k) {
    ok &= static_cast<int>(box.min[k] >= extent.min[k]) &
          static_cast<int>(box.max[k] <= extent.max[k]) &
          static_cast<int>(box.min[k] <= box.max[k]);
  }
  return ok;
}

void check_extent(const BoxMap::Data& data, std::size_t t, std::size_t begin, std::size_t end) {
  const Tile tile = data.tiles[t];
  for (std::size_t i = begin; i < end; ++i) {
    if (!is_ordered_inside(data.boxes[i], tile.extent)) {
      refuse(data, {.key = fmt::format("box {}", i),
                    .expected = fmt::format(
                        "finite, with min <= max, inside the extent of its tile {}, which is {}", t,
                        shown(tile.extent)),
                    .found = shown(data.boxes[i])});
    }
    if (data.label[i] >= data.labels.size()) {
      refuse(data, {.key = fmt::format("label of box {}", i),
                    .expected = fmt::format("below {}", data.labels.size()),
                    .found = fmt::to_string(data.label[i])});
    }
  }
}

void check_place(const BoxMap::Data& data, std::size_t t, std::size_t begin, std::size_t end) {
  const Tile tile = data.tiles[t];
  for (std::size_t i = begin; i < end; ++i) {
    if (place_of(data.boxes[i], data.spec.tile_size) != place_of(tile)) {
      refuse(data, {.says = fmt::format(
                        "box {} must lie in the square of its tile {}, column {}, row {}{}", i, t,
                        tile.ix, tile.iy, tile.large ? " (large)" : ""),
                    .found = shown(data.boxes[i])});
    }
    if (i == tile.first || comes_before(data.boxes[i - 1], data.boxes[i])) continue;
    if (data.boxes[i - 1] == data.boxes[i] && data.ids[i - 1] < data.ids[i]) continue;
    if (data.boxes[i - 1] == data.boxes[i] && data.ids[i - 1] == data.ids[i] &&
        data.timed.of(i - 1) <= data.timed.of(i)) {
      continue;
    }
    refuse(data, {.says = fmt::format(
                      "box {} of tile {} must not come before box {}, by min, max, id and time", i,
                      t, i - 1)});
  }
}

}  // namespace

void verify_extents(const BoxMap::Data& data, const Execution& run) {
  for_each_stretch_of_tiles(data, run, [&](std::size_t t, std::size_t begin, std::size_t end) {
    check_extent(data, t, begin, end);
  });
}

void verify_contents(const BoxMap::Data& data, const Execution& run) {
  data.archive->verify(run);
  for_each_stretch_of_tiles(data, run, [&](std::size_t t, std::size_t begin, std::size_t end) {
    check_place(data, t, begin, end);
  });
  const std::string found = hash_of(data.spec, data.tiles.all(), data.boxes, data.timed, run);
  if (found != data.hash) {
    refuse(data, {.says = fmt::format("the map names the hash {}, and its boxes have {}", data.hash,
                                      found)});
  }
}

}  // namespace geom
