#include "geom/map/column_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "cell_index.h"
#include "cell_tiles.h"
#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "shape/row_merge.h"

namespace geom {

struct ColumnGrid::Impl {
  explicit Impl(const ColumnSpec& spec);

  void add(const Vec3& p);
  void add(const Vec3& p, double reach);
  std::vector<std::int32_t> spans();
  void add_span(std::int32_t x, std::int32_t y, std::int32_t low, std::int32_t high);
  BoxTable boxes(std::string_view source);
  std::size_t cells();

  struct Span {  // of heights, in steps: closed
    std::int32_t low;
    std::int32_t high;

    friend bool operator==(const Span&, const Span&) = default;
  };
  using Spans = std::span<const Span>;  // ascending, further apart than the gap
  // The spans of a cell: a few in place, more in a list of their own. A lone return takes 6 KiB, as
  // cells stand in tiles.
  struct Column {
    std::uint32_t count = 0;
    std::uint32_t list = 0;  // 1 + the index of its list, where it ever had one
    std::array<Span, 2> few{};
  };
  using Tiles = CellTiles<Column>;
  using TileAt = std::vector<const Tiles::Tile*>::const_iterator;
  static constexpr int kSide = Tiles::kSide;

  struct Labelled {
    Span span;
    std::uint32_t label;

    friend bool operator==(const Labelled&, const Labelled&) = default;
  };

  // The rectangle of cells with returns, ends among them, and the heights of all; x0 > x1: none.
  struct Extent {
    static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    std::int32_t x0 = kMost, x1 = -kMost;
    std::int32_t y0 = kMost, y1 = -kMost;
    Span heights{kMost, -kMost};
  };

  Spans spans_of(const Column& column) const {
    if (column.count <= column.few.size()) return {column.few.data(), column.count};
    return lists_[column.list - 1];
  }
  void merge_into(Column& column, const Span& span);
  Extent extent() const;
  std::vector<Labelled> labelled(Spans column, const Span& heights) const;
  // Calls visit(y, x, spans) by ascending y, then x, for each cell with returns and, with
  // unknown_blocked, for all others of the rectangle; and the same for one row, whose tiles these
  // are.
  template <class Visit>
  void visit_cells(const Extent& e, const Visit& visit) const;
  template <class Visit>
  void visit_row(TileAt tile, TileAt end, std::int32_t y, const Extent& e,
                 const Visit& visit) const;

  // A span on its way into a column.
  struct Pending {
    Column* column = nullptr;
    Span span{};
  };
  void settle(const Pending& pending);
  void settle_all();

  ColumnSpec spec_;
  std::int64_t gap_;  // steps; no two are 2^33 apart
  // Points come in no order, and each column is elsewhere in memory: a few wait for theirs.
  std::array<Pending, 32> pending_;
  std::size_t next_ = 0;  // of these, the one that has waited longest
  Tiles tiles_;
  std::vector<std::vector<Span>> lists_;
  std::vector<Span> merged_;  // of the column that changes
};

ColumnGrid::Impl::Impl(const ColumnSpec& spec) : spec_(spec) {
  require_size("cell", spec.cell);
  require_size("step", spec.step);
  require_length("gap", spec.gap, kLargestCoordinate);
  gap_ = static_cast<std::int64_t>(std::min(std::floor(spec.gap / spec.step), 0x1p33));
}

void ColumnGrid::Impl::add(const Vec3& p) {
  Span span{floor_index(p.z(), spec_.step), ceil_index(p.z(), spec_.step)};
  if (span.low == span.high) ++span.high;  // on a step: some height, so that boxes join
  add_span(floor_index(p.x(), spec_.cell), floor_index(p.y(), spec_.cell), span.low, span.high);
}

void ColumnGrid::Impl::add(const Vec3& p, double reach) {
  const auto low = [&](double v, double size) { return floor_index(v - reach, size); };
  const auto high = [&](double v, double size) { return floor_index(v + reach, size); };
  Span span{low(p.z(), spec_.step), ceil_index(p.z() + reach, spec_.step)};
  if (span.low == span.high) ++span.high;
  for (std::int32_t y = low(p.y(), spec_.cell); y <= high(p.y(), spec_.cell); ++y) {
    for (std::int32_t x = low(p.x(), spec_.cell); x <= high(p.x(), spec_.cell); ++x) {
      add_span(x, y, span.low, span.high);
    }
  }
}

std::vector<std::int32_t> ColumnGrid::Impl::spans() {
  settle_all();
  std::vector<std::int32_t> rows;
  for (const Tiles::Tile* tile : tiles_.sorted()) {
    for (int i = 0; i < kSide * kSide; ++i) {
      for (const Span& span : spans_of(tile->cells[static_cast<std::size_t>(i)])) {
        rows.insert(rows.end(), {tile->x * kSide + i % kSide, tile->y * kSide + i / kSide, span.low,
                                 span.high});
      }
    }
  }
  return rows;
}

void ColumnGrid::Impl::add_span(std::int32_t x, std::int32_t y, std::int32_t low,
                                std::int32_t high) {
  Pending& pending = pending_[next_];
  next_ = (next_ + 1) % pending_.size();
  settle(pending);
  pending = {&tiles_.at(x, y), {low, high}};
  __builtin_prefetch(pending.column, 1);
}

void ColumnGrid::Impl::settle_all() {
  for (Pending& pending : pending_) settle(std::exchange(pending, {}));
}

void ColumnGrid::Impl::settle(const Pending& pending) {
  if (!pending.column) return;
  const Spans known = spans_of(*pending.column);
  const bool inside = std::any_of(known.begin(), known.end(), [&](const Span& s) {
    return s.low <= pending.span.low && pending.span.high <= s.high;
  });
  if (!inside) merge_into(*pending.column, pending.span);
}

void ColumnGrid::Impl::merge_into(Column& column, const Span& span) {
  const Spans known = spans_of(column);
  merged_.assign(known.begin(), known.end());
  const auto near = [&](const Span& s) {
    return static_cast<std::int64_t>(s.low) - span.high <= gap_ &&
           static_cast<std::int64_t>(span.low) - s.high <= gap_;
  };
  // What is near is consecutive; it and the new one become one, which may reach no others: those
  // are further from it than the gap, or would be near themselves.
  const auto first = std::find_if(merged_.begin(), merged_.end(), near);
  if (first == merged_.end()) {
    merged_.insert(std::find_if(merged_.begin(), merged_.end(),
                                [&](const Span& s) { return s.low > span.high; }),
                   span);
  } else {
    const auto last = std::find_if_not(first, merged_.end(), near);
    first->low = std::min(first->low, span.low);
    first->high = std::max((last - 1)->high, span.high);
    merged_.erase(first + 1, last);
  }
  column.count = static_cast<std::uint32_t>(merged_.size());
  if (merged_.size() <= column.few.size()) {
    std::copy(merged_.begin(), merged_.end(), column.few.begin());
    return;
  }
  if (column.list == 0) {
    lists_.emplace_back();
    column.list = static_cast<std::uint32_t>(lists_.size());
  }
  lists_[column.list - 1] = merged_;
}

std::vector<ColumnGrid::Impl::Labelled> ColumnGrid::Impl::labelled(Spans column,
                                                                   const Span& heights) const {
  std::vector<Labelled> out;
  std::int32_t reached = heights.low;
  for (const Span& span : column) {
    if (spec_.unknown_blocked && span.low > reached) out.push_back({{reached, span.low}, 1});
    out.push_back({span, 0});
    reached = span.high;
  }
  if (spec_.unknown_blocked && column.empty()) out.push_back({heights, 1});
  return out;
}

std::size_t ColumnGrid::Impl::cells() {
  settle_all();
  std::size_t count = 0;
  for (const Tiles::Tile* tile : tiles_.sorted()) {
    count +=
        static_cast<std::size_t>(std::count_if(tile->cells.get(), tile->cells.get() + kSide * kSide,
                                               [](const Column& c) { return c.count > 0; }));
  }
  return count;
}

ColumnGrid::Impl::Extent ColumnGrid::Impl::extent() const {
  Extent e;
  for (const Tiles::Tile* tile : tiles_.sorted()) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const Spans c = spans_of(tile->cells[static_cast<std::size_t>(i)]);
      if (c.empty()) continue;
      e.heights = {std::min(e.heights.low, c.front().low), std::max(e.heights.high, c.back().high)};
      e.x0 = std::min(e.x0, tile->x * kSide + i % kSide);
      e.x1 = std::max(e.x1, tile->x * kSide + i % kSide);
      e.y0 = std::min(e.y0, tile->y * kSide + i / kSide);
      e.y1 = std::max(e.y1, tile->y * kSide + i / kSide);
    }
  }
  return e;
}

template <class Visit>
void ColumnGrid::Impl::visit_row(TileAt tile, TileAt end, std::int32_t y, const Extent& e,
                                 const Visit& visit) const {
  std::int32_t x = e.x0;  // the next cell
  const auto visit_to = [&](std::int32_t to) {
    for (; spec_.unknown_blocked && x < to; ++x) visit(y, x, Spans());
    x = std::max(x, to);
  };
  for (; tile != end; ++tile) {
    const std::int32_t left = (*tile)->x * kSide;
    const std::int32_t row = (y - (*tile)->y * kSide) * kSide;
    visit_to(std::clamp(left, e.x0, e.x1 + 1));
    // By what is left of the tile: its end may be 2^31, one more than an index holds.
    for (; x - left < kSide && x <= e.x1; ++x) {
      const Spans c = spans_of((*tile)->cells[static_cast<std::size_t>(row + (x - left))]);
      if (!c.empty() || spec_.unknown_blocked) visit(y, x, c);
    }
  }
  visit_to(e.x1 + 1);
}

template <class Visit>
void ColumnGrid::Impl::visit_cells(const Extent& e, const Visit& visit) const {
  const auto tiles = tiles_.sorted();
  std::int32_t y = e.y0;  // the next row
  for (TileAt tile = tiles.begin(); tile != tiles.end();) {
    const std::int32_t ty = (*tile)->y;
    const TileAt end =
        std::find_if(tile, tiles.end(), [&](const Tiles::Tile* t) { return t->y != ty; });
    // Rows between those of tiles hold nothing.
    for (; spec_.unknown_blocked && y < ty * kSide; ++y) visit_row(end, end, y, e, visit);
    y = std::max(y, ty * kSide);
    for (; y <= std::min(e.y1, ty * kSide + kSide - 1); ++y) visit_row(tile, end, y, e, visit);
    tile = end;
  }
}

BoxTable ColumnGrid::Impl::boxes(std::string_view source) {
  settle_all();
  BoxTable table;
  table.labels = {"", "unknown"};
  const Extent e = extent();
  if (e.x0 > e.x1) return table;
  const double cells =
      (static_cast<double>(e.x1) - e.x0 + 1) * (static_cast<double>(e.y1) - e.y0 + 1);
  if (spec_.unknown_blocked && cells > 2e8) {
    throw InputError(source, {.expected = "at most 2e8 cells in the rectangle around the points",
                              .found = fmt::to_string(cells),
                              .advice = "use larger cells"});
  }
  const auto emit = [&](const CellRectangle<std::vector<Labelled>>& r) {
    for (const Labelled& l : r.value) {
      table.add({{static_cast<double>(r.first_column) * spec_.cell,
                  static_cast<double>(r.first_row) * spec_.cell, l.span.low * spec_.step},
                 {static_cast<double>(r.last_column) * spec_.cell,
                  static_cast<double>(r.last_row) * spec_.cell, l.span.high * spec_.step}},
                table.ids.size(), l.label);
    }
  };
  RowMerge<std::vector<Labelled>, decltype(emit)> merge(emit);
  visit_cells(e, [&](std::int32_t y, std::int32_t x, Spans column) {
    merge.add(y, x, labelled(column, e.heights));
  });
  merge.finish();
  return table;
}

ColumnGrid::ColumnGrid(const ColumnSpec& spec) : impl_(std::make_unique<Impl>(spec)) {}
ColumnGrid::~ColumnGrid() = default;
ColumnGrid::ColumnGrid(ColumnGrid&&) noexcept = default;

void ColumnGrid::add(const Vec3& p, double reach) {
  if (reach > 0) {
    impl_->add(p, reach);
  } else {
    impl_->add(p);
  }
}
std::vector<std::int32_t> ColumnGrid::spans() const { return impl_->spans(); }
void ColumnGrid::add_span(std::int32_t x, std::int32_t y, std::int32_t low, std::int32_t high) {
  impl_->add_span(x, y, low, high);
}
BoxTable ColumnGrid::boxes(std::string_view source) const { return impl_->boxes(source); }
std::size_t ColumnGrid::cells() const { return impl_->cells(); }

}  // namespace geom
