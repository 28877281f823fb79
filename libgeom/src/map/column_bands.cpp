#include "column_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/large_vector.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "shape/row_merge.h"

namespace geom {
namespace {

constexpr int kSide = ColumnShard::Tiles::kSide;

// A rectangle of cells, ends among them, and the heights in it; x0 > x1: none.
struct Extent {
  static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  std::int32_t x0 = kMost, x1 = -kMost;
  std::int32_t y0 = kMost, y1 = -kMost;
  HeightSpan heights{kMost, -kMost};

  void add(const Extent& o) {
    x0 = std::min(x0, o.x0), x1 = std::max(x1, o.x1);
    y0 = std::min(y0, o.y0), y1 = std::max(y1, o.y1);
    heights = {std::min(heights.low, o.heights.low), std::max(heights.high, o.heights.high)};
  }
  double cells() const {
    return (static_cast<double>(x1) - x0 + 1) * (static_cast<double>(y1) - y0 + 1);
  }
};

Extent extent_of(const ColumnTile& tile) {
  Extent e;
  for (int i = 0; i < kSide * kSide; ++i) {
    const HeightSpans c = tile.spans(i);
    if (c.empty()) continue;
    const std::int32_t x = tile.tile->x * kSide + i % kSide;
    const std::int32_t y = tile.tile->y * kSide + i / kSide;
    e.add({x, x, y, y, {c.front().low, c.back().high}});
  }
  return e;
}

// Of whole tiles, without their heights.
Extent extent_of_tiles(std::span<const ColumnTile> tiles) {
  Extent e;
  for (const ColumnTile& t : tiles) {
    const std::int32_t x = t.tile->x * kSide;
    const std::int32_t y = t.tile->y * kSide;
    e.add({x, x + (kSide - 1), y, y + (kSide - 1), {}});
  }
  return e;
}

// Of the cells with returns.
Extent extent_of(std::span<const ColumnTile> tiles, const Execution& run) {
  constexpr std::size_t kTogether = 64;
  std::vector<Extent> parts((tiles.size() + kTogether - 1) / kTogether);
  parallel_for(parts.size(), {run.threads, {}}, [&](std::size_t p) {
    const std::size_t end = std::min(tiles.size(), (p + 1) * kTogether);
    for (std::size_t t = p * kTogether; t < end; ++t) parts[p].add(extent_of(tiles[t]));
  });
  Extent all;
  for (const Extent& part : parts) all.add(part);
  return all;
}

struct SameHeights {
  bool operator()(const HeightSpans& a, const HeightSpans& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
};

// Rows that tiles stand in side by side, or that none stands in.
struct Band {
  using Rectangle = CellRectangle<HeightSpans>;

  std::span<const ColumnTile> tiles;
  std::int32_t first_row = 0;
  std::int32_t last_row = 0;          // among them
  std::vector<Rectangle> rectangles;  // by last row, then by column
  std::size_t boxes = 0;              // that they make, and
  std::size_t boxes_before = 0;       // those of all bands before

  long end() const { return long{last_row} + 1; }
  static bool is_gone(const Rectangle& r) { return r.first_row == r.last_row; }
};

// Makes the boxes of all bands.
class BandBoxes {
 public:
  BandBoxes(std::span<const ColumnTile> tiles, const ColumnSpec& spec, const Extent& extent,
            const Execution& run)
      : spec_(spec), extent_(extent), run_{run.threads, {}}, bands_(bands_of(tiles)) {}

  BoxTable table() {
    parallel_for(bands_.size(), run_, [&](std::size_t b) { find_rectangles(bands_[b]); });
    for (std::size_t b = 1; b < bands_.size(); ++b) join(bands_[b - 1], bands_[b]);
    parallel_for(bands_.size(), run_, [&](std::size_t b) { count(bands_[b]); });
    std::size_t boxes = 0;
    for (Band& band : bands_) {
      band.boxes_before = boxes;
      boxes += band.boxes;
    }
    BoxTable table;
    table.labels = {"", "unknown"};
    resize_large(table.boxes, boxes, run_);
    resize_large(table.ids, boxes, run_);
    resize_large(table.label, boxes, run_);
    parallel_for(bands_.size(), run_, [&](std::size_t b) {
      fill(bands_[b], table);
      bands_[b].rectangles = {};
    });
    return table;
  }

 private:
  std::vector<Band> bands_of(std::span<const ColumnTile> tiles) const;
  void find_rectangles(Band& band) const;
  static void join(Band& above, Band& band);
  void count(Band& band) const;
  void fill(const Band& band, BoxTable& table) const;
  template <class Merge>
  void add_row(const Band& band, std::int32_t y, Merge& merge) const;
  template <class Merge>
  void add_whole_row(const Band& band, std::int32_t y, Merge& merge) const;
  template <class F>
  void for_each_box(HeightSpans column, const F& f) const;

  const ColumnSpec& spec_;
  const Extent& extent_;
  Execution run_;
  std::vector<Band> bands_;
};

std::vector<Band> BandBoxes::bands_of(std::span<const ColumnTile> tiles) const {
  std::vector<Band> bands;
  const auto add = [&](std::int32_t ty, std::span<const ColumnTile> of) {
    bands.push_back(
        {of, std::max(extent_.y0, ty * kSide), std::min(extent_.y1, ty * kSide + kSide - 1)});
  };
  std::int32_t next = extent_.y0 >> 4;  // row of tiles
  while (!tiles.empty()) {
    const std::int32_t ty = tiles.front().tile->y;
    const auto end = std::find_if(tiles.begin(), tiles.end(),
                                  [&](const ColumnTile& t) { return t.tile->y != ty; });
    const auto count = static_cast<std::size_t>(end - tiles.begin());
    if (ty * kSide + (kSide - 1) >= extent_.y0 && ty * kSide <= extent_.y1) {
      for (; spec_.unknown_blocked && next < ty; ++next) add(next, {});
      add(ty, tiles.first(count));
      next = ty + 1;
    }
    tiles = tiles.subspan(count);
  }
  return bands;
}

template <class Merge>
void BandBoxes::add_row(const Band& band, std::int32_t y, Merge& merge) const {
  if (spec_.unknown_blocked) return add_whole_row(band, y, merge);
  for (const ColumnTile& tile : band.tiles) {
    const std::int32_t left = tile.tile->x * kSide;
    const std::int32_t row = (y - tile.tile->y * kSide) * kSide;
    for (std::int32_t i = 0; i < kSide; ++i) {
      const HeightSpans c = tile.spans(row + i);
      if (!c.empty()) merge.add(y, left + i, c);
    }
  }
}

// Adds all cells of the rectangle in a row, with returns and without.
template <class Merge>
void BandBoxes::add_whole_row(const Band& band, std::int32_t y, Merge& merge) const {
  std::int32_t x = extent_.x0;  // the next cell
  const auto pass_to = [&](std::int32_t to) {
    if (x < to) merge.add(y, x, to, HeightSpans());
    x = std::max(x, to);
  };
  for (const ColumnTile& tile : band.tiles) {
    const std::int32_t left = tile.tile->x * kSide;
    const std::int32_t row = (y - tile.tile->y * kSide) * kSide;
    pass_to(std::clamp(left, extent_.x0, extent_.x1 + 1));
    // By what is left of the tile: its end may be 2^31, one more than an index holds.
    for (; x - left < kSide && x <= extent_.x1; ++x) {
      merge.add(y, x, tile.spans(row + (x - left)));
    }
  }
  pass_to(extent_.x1 + 1);
}

void BandBoxes::find_rectangles(Band& band) const {
  const auto emit = [&](const Band::Rectangle& r) { band.rectangles.push_back(r); };
  RowMerge<HeightSpans, decltype(emit), SameHeights> merge(emit);
  for (std::int64_t y = band.first_row; y <= band.last_row; ++y) {
    add_row(band, static_cast<std::int32_t>(y), merge);
  }
  merge.finish();
}

// Rectangles that end with a band go on in the next where that begins with the same: then they are
// there. So all of them stay in the order in which one merge of all rows would give them.
void BandBoxes::join(Band& above, Band& band) {
  if (above.end() != band.first_row) return;
  const auto begin =
      std::partition_point(above.rectangles.begin(), above.rectangles.end(),
                           [&](const Band::Rectangle& r) { return r.last_row < above.end(); });
  std::vector<Band::Rectangle*> tops;
  for (Band::Rectangle& r : band.rectangles) {
    if (r.first_row == band.first_row) tops.push_back(&r);
  }
  std::sort(tops.begin(), tops.end(), [](const Band::Rectangle* a, const Band::Rectangle* b) {
    return a->first_column < b->first_column;
  });
  auto top = tops.begin();
  for (auto open = begin; open != above.rectangles.end(); ++open) {
    while (top != tops.end() && (*top)->first_column < open->first_column) ++top;
    if (top == tops.end()) return;
    const bool same = (*top)->first_column == open->first_column &&
                      (*top)->last_column == open->last_column &&
                      SameHeights()((*top)->value, open->value);
    if (same) (*top)->first_row = std::exchange(open->first_row, open->last_row);
  }
}

// Calls f(heights, label) for each box of a column, from the lowest up.
template <class F>
void BandBoxes::for_each_box(HeightSpans column, const F& f) const {
  std::int32_t reached = extent_.heights.low;
  for (const HeightSpan& span : column) {
    if (spec_.unknown_blocked && span.low > reached) f(HeightSpan{reached, span.low}, 1u);
    f(span, 0u);
    reached = span.high;
  }
  if (spec_.unknown_blocked && column.empty()) f(extent_.heights, 1u);
}

void BandBoxes::count(Band& band) const {
  for (const Band::Rectangle& r : band.rectangles) {
    if (Band::is_gone(r)) continue;
    for_each_box(r.value, [&](const HeightSpan&, std::uint32_t) { ++band.boxes; });
  }
}

void BandBoxes::fill(const Band& band, BoxTable& table) const {
  std::size_t i = band.boxes_before;
  for (const Band::Rectangle& r : band.rectangles) {
    if (Band::is_gone(r)) continue;
    for_each_box(r.value, [&](const HeightSpan& heights, std::uint32_t label) {
      table.boxes[i] = {{static_cast<double>(r.first_column) * spec_.cell,
                         static_cast<double>(r.first_row) * spec_.cell, heights.low * spec_.step},
                        {static_cast<double>(r.last_column) * spec_.cell,
                         static_cast<double>(r.last_row) * spec_.cell, heights.high * spec_.step}};
      table.ids[i] = i;
      table.label[i] = label;
      ++i;
    });
  }
}

}  // namespace

BoxTable boxes_of_columns(std::span<const ColumnTile> tiles, const ColumnSpec& spec,
                          std::string_view source, const Execution& run) {
  const Extent extent = spec.unknown_blocked ? extent_of(tiles, run) : extent_of_tiles(tiles);
  if (extent.x0 > extent.x1) {
    BoxTable none;
    none.labels = {"", "unknown"};
    return none;
  }
  if (spec.unknown_blocked && extent.cells() > 2e8) {
    throw InputError(source, {.expected = "at most 2e8 cells in the rectangle around the points",
                              .found = fmt::to_string(extent.cells()),
                              .advice = "use larger cells"});
  }
  return BandBoxes(tiles, spec, extent, run).table();
}

}  // namespace geom
