#pragma once

// Points as columns: the boxes of a laser scan.

#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

#include "geom/map/box_map.h"

namespace geom {

struct ColumnSpec {
  double cell = 1;               // metres, side of a column
  double step = 0.5;             // metres: heights are rounded outward to multiples of it
  double gap = 2;                // metres: returns of a column further apart leave free space
  bool unknown_blocked = false;  // what was not scanned becomes boxes labelled "unknown"
};

// Collects points, in any order; memory grows with the area that they cover, not with their number.
// Indices of cells and steps must fit 31 bits, |coordinate| / cell < 2^31: InputError otherwise,
// and where a size is not > 0 or the gap < 0.
class ColumnGrid {
 public:
  explicit ColumnGrid(const ColumnSpec& spec);

  void add(const Vec3& p);

  // What stands in the columns, as rows of four: cell along x, along y, lowest and highest step;
  // and one of them added, of this or another grid of the same spec. Grids whose spans are all
  // added to one make what their points would.
  std::vector<std::int32_t> spans() const;
  void add_span(std::int32_t x, std::int32_t y, std::int32_t low, std::int32_t high);

  // Closed boxes that contain every point added, columns of equal heights joined. With
  // unknown_blocked also: below and between a column's returns down to the lowest of all, and over
  // that to the highest in cells without returns, within the rectangle around all cells. Throws
  // InputError(source, …) where that rectangle has more than 2e8 cells. The same for any order of
  // the points. Empty without points.
  BoxTable boxes(std::string_view source) const;

  std::size_t cells() const;  // with returns

 private:
  static constexpr int kSide = 16;  // cells of a tile: a lone return takes 6 KiB

  struct Span {  // of heights, in steps: closed
    std::int32_t low;
    std::int32_t high;

    friend bool operator==(const Span&, const Span&) = default;
  };
  using Column = std::vector<Span>;  // ascending, further apart than the gap
  using Tile = std::vector<Column>;
  struct Labelled {
    Span span;
    std::uint32_t label;

    friend bool operator==(const Labelled&, const Labelled&) = default;
  };

  using Tiles = std::map<std::pair<std::int32_t, std::int32_t>, Tile>;  // by y, then x

  // The rectangle of cells with returns, ends among them, and the heights of all; x0 > x1: none.
  struct Extent {
    static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    std::int32_t x0 = kMost, x1 = -kMost;
    std::int32_t y0 = kMost, y1 = -kMost;
    Span heights{kMost, -kMost};
  };

  Column& column(std::int32_t x, std::int32_t y);
  Extent extent() const;
  std::vector<Labelled> labelled(const Column& column, const Span& heights) const;
  // Calls visit(y, x, column) by ascending y, then x, for each cell with returns and, with
  // unknown_blocked, for all others of the rectangle; and the same for one row, whose tiles these
  // are.
  template <class Visit>
  void visit_cells(const Extent& e, const Visit& visit) const;
  template <class Visit>
  void visit_row(Tiles::const_iterator tile, Tiles::const_iterator end, std::int32_t y,
                 const Extent& e, const Visit& visit) const;

  ColumnSpec spec_;
  Tiles tiles_;
  std::pair<std::int32_t, std::int32_t> last_key_{};
  Tile* last_ = nullptr;
};

struct GroundSpec {
  double cell = 2;      // metres
  double slope = 0.1;   // metres up a metre aside: what rises faster is no ground
  double height = 0.3;  // metres above the ground of a cell, sloped as to its neighbours
};

// The ground of a scan: the lowest return of each cell, lowered to what its neighbours allow at the
// slope. Add all points, finish(), then ask. InputError as of a ColumnGrid.
class GroundGrid {
 public:
  explicit GroundGrid(const GroundSpec& spec);

  void add(const Vec3& p);
  void finish();
  bool is_ground(const Vec3& p) const;

 private:
  using Key = std::pair<std::int32_t, std::int32_t>;
  Key key(const Vec3& p) const;

  GroundSpec spec_;
  std::map<Key, double> lowest_;
};

}  // namespace geom
