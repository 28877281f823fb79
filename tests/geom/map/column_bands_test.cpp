#include "map/column_bands.h"

#include <gtest/gtest.h>

#include <map>

#include "shape/row_merge.h"
#include "support/random_city.h"

namespace geom {
namespace {

using Heights = std::vector<HeightSpan>;
using Cells = std::map<std::pair<int, int>, Heights>;  // by row, then column

// Few heights, in patches, so that many neighbours are equal and many are not.
std::vector<CellSpan> some_spans(std::uint64_t seed, int count, int side) {
  support::Random random(seed);
  std::vector<CellSpan> spans;
  for (int i = 0; i < count; ++i) {
    const int x = random.below(side) - side / 2;
    const int y = random.below(side) - side / 2;
    const int low = random.below(3) ? 0 : 20 * random.below(3);
    const int across = 1 + random.below(9);
    const int along = 1 + random.below(40);
    for (int dy = 0; dy < along; ++dy) {
      for (int dx = 0; dx < across; ++dx) spans.push_back({x + dx, y + dy, {low, low + 4}});
    }
  }
  return spans;
}

Cells cells_of(const std::vector<CellSpan>& spans) {
  Cells cells;
  for (const CellSpan& s : spans) {
    Heights& heights = cells[{s.y, s.x}];
    if (std::find(heights.begin(), heights.end(), s.span) != heights.end()) continue;
    heights.push_back(s.span);
    std::sort(heights.begin(), heights.end(),
              [](const HeightSpan& a, const HeightSpan& b) { return a.low < b.low; });
  }
  return cells;
}

// One merge of all rows, and then the boxes of each rectangle.
std::vector<Aabb> boxes_by_definition(const Cells& cells, bool unknown_blocked) {
  int x0 = 1000, x1 = -1000, y0 = 1000, y1 = -1000, low = 1000, high = -1000;
  for (const auto& [at, heights] : cells) {
    x0 = std::min(x0, at.second), x1 = std::max(x1, at.second);
    y0 = std::min(y0, at.first), y1 = std::max(y1, at.first);
    low = std::min(low, heights.front().low), high = std::max(high, heights.back().high);
  }
  std::vector<Aabb> boxes;
  const auto emit = [&](const CellRectangle<Heights>& r) {
    const auto add = [&](double from, double to) {
      boxes.push_back({{r.first_column * 2.0, r.first_row * 2.0, from * 0.5},
                       {r.last_column * 2.0, r.last_row * 2.0, to * 0.5}});
    };
    int reached = low;
    for (const HeightSpan& s : r.value) {
      if (unknown_blocked && s.low > reached) add(reached, s.low);
      add(s.low, s.high);
      reached = s.high;
    }
    if (unknown_blocked && r.value.empty()) add(low, high);
  };
  RowMerge<Heights, decltype(emit)> merge(emit);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const auto at = cells.find({y, x});
      if (at != cells.end())
        merge.add(y, x, at->second);
      else if (unknown_blocked)
        merge.add(y, x, {});
    }
  }
  merge.finish();
  return boxes;
}

TEST(ColumnBands, GiveTheBoxesOfOneMergeOfAllRowsInItsOrder) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const std::vector<CellSpan> spans = some_spans(seed, 2 + static_cast<int>(seed) * 3, 150);
    ColumnShard shard;
    shard.add(spans, 0);
    std::vector<ColumnTile> tiles;
    for (const auto* tile : shard.tiles().sorted()) tiles.push_back({tile, &shard});
    for (const bool unknown_blocked : {false, true}) {
      const auto expected = boxes_by_definition(cells_of(spans), unknown_blocked);
      for (const unsigned threads : {1u, 2u, 7u}) {
        const BoxTable table =
            boxes_of_columns(tiles, {2, 0.5, 0, unknown_blocked}, "test", {threads, {}});
        ASSERT_TRUE(table.boxes == expected) << seed << ", " << unknown_blocked;
        for (std::size_t i = 0; i < table.ids.size(); ++i) ASSERT_EQ(table.ids[i], i);
      }
    }
  }
}

}  // namespace
}  // namespace geom
