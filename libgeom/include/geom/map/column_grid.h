#pragma once

// Points as columns: the boxes of a laser scan.
//
// Example:
//   geom::ColumnGrid grid({.cell = 1, .step = 0.5, .gap = 2});
//   grid.add({0.2, 0.3, 0.1});
//   grid.add({0.7, 0.8, 1.4});
//   const geom::BoxTable boxes = grid.boxes("scan.xyz");
//   assert(boxes.boxes[0] == (geom::Aabb{{0, 0, 0}, {1, 1, 1.5}}));

#include <memory>
#include <span>
#include <string_view>

#include "geom/base/execution.h"
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
  ~ColumnGrid();
  ColumnGrid(ColumnGrid&&) noexcept;

  // Adds the point, and with a reach (metres, >= 0) all that is so near to it along each axis.
  void add(const Vec3& p, double reach = 0);

  // The same of many points, on all threads. Faster than one by one, also on one thread. What it
  // keeps of them waits for more points, or for boxes(), to be sorted into the cells.
  void add(std::span<const Vec3> points, double reach = 0, const Execution& run = {});

  // Sorts a small part of what waits into its cells, for a thread that would be idle. False: too
  // little waits to be worth it.
  bool sort_some();

  // Closed boxes that contain every point added, columns of equal heights joined. With
  // unknown_blocked also: below and between a column's returns down to the lowest of all, and over
  // that to the highest in cells without returns, within the rectangle around all cells. Throws
  // InputError(source, …) where that rectangle has more than 2e8 cells. The same for any order of
  // the points. Empty without points.
  BoxTable boxes(std::string_view source, const Execution& run = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace geom
