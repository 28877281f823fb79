#pragma once

// Cells of a grid as columns of their heights, row by row, as few rectangles that are as high.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "shape/row_merge.h"

namespace geom {

// Takes the heights of whole rows, from row 0 on; calls `emit` for each rectangle of cells
// (CellRectangle<double>, its value a height) once it can grow no more. All that stands on the
// rectangles together is all that stands on the cells: each cell lies in a rectangle of its own
// height, and in none that is higher. Rectangles overlap, since one passes below cells that are
// higher than it: a tree does not cut the ground around it.
//
// A rectangle has at most `most_columns` and `most_rows` (both >= 1), but for runs of one height
// that are kWide times as long and more: these grow while the next row repeats them exactly.
// Memory: two rows. Cost: that of sorting each row.
template <class Emit>
class SkylineMerge {
 public:
  static constexpr long kWide = 8;

  SkylineMerge(Emit emit, long most_columns, long most_rows)
      : emit_(std::move(emit)), most_columns_(most_columns), most_rows_(most_rows) {}

  // NaN where there is no cell.
  void add_row(std::span<const double> heights) {
    find_parts(heights);
    join_parts();
    ++row_;
  }

  void finish() {
    for (const Part& open : open_) emit_(open.cells);
    open_.clear();
  }

 private:
  struct Part {
    CellRectangle<double> cells;  // from the first to the last that need it
    long low = 0;                 // columns [low, high) are as high, or higher
    long high = 0;
    bool wide = false;

    friend bool operator<(const Part& a, const Part& b) { return a.order() < b.order(); }
    auto order() const {
      return std::tie(cells.value, cells.first_column, cells.last_column, cells.first_row);
    }
  };

  // Of this row: for each height and each stretch of cells that are no lower, those of that height.
  void find_parts(std::span<const double> heights) {
    const auto count = static_cast<long>(heights.size());
    const auto height = [&](long i) { return heights[static_cast<std::size_t>(i)]; };
    for (long first = 0; first < count;) {
      long last = first + 1;
      if (std::isnan(height(first))) {
        end_above(-std::numeric_limits<double>::infinity(), first);
      } else {
        while (last < count && height(last) == height(first)) ++last;
        const long low = end_above(height(first), first);
        add_run(height(first), first, last, low);
      }
      first = last;
    }
    end_above(-std::numeric_limits<double>::infinity(), count);
    std::sort(parts_.begin(), parts_.end());
  }

  // Ends the stretches that are higher, at a column; returns where the one of this height begins.
  long end_above(double height, long column) {
    long low = column;
    while (!stretches_.empty() && stretches_.back().cells.value >= height) {
      Part& top = stretches_.back();
      low = top.low;
      if (top.cells.value == height) break;
      top.high = column;
      parts_.push_back(top);
      stretches_.pop_back();
    }
    return low;
  }

  void add_run(double height, long first, long last, long low) {
    const auto push = [&](long from, long to, bool wide) {
      stretches_.push_back({{from, to, row_, row_ + 1, height}, low, 0, wide});
    };
    if (last - first >= kWide * most_columns_) return push(first, last, true);
    if (!stretches_.empty() && stretches_.back().cells.value == height && !stretches_.back().wide) {
      CellRectangle<double>& cells = stretches_.back().cells;
      const long to = std::min(last, cells.first_column + most_columns_);
      if (to > first) {
        cells.last_column = to;
        first = to;
      }
    }
    for (; first < last; first += most_columns_) {
      push(first, std::min(last, first + most_columns_), false);
    }
  }

  // Both are in order, and so is what they become, nearly.
  void join_parts() {
    joined_.clear();
    auto next = parts_.begin();
    for (const Part& open : open_) {
      while (next != parts_.end() &&
             (next->cells.value < open.cells.value ||
              (next->cells.value == open.cells.value && next->cells.last_column <= open.low))) {
        joined_.push_back(*next++);
      }
      const long end = std::min(open.high, open.cells.first_column + most_columns_);
      auto same = next;
      while (same != parts_.end() && same->cells.value == open.cells.value &&
             same->cells.first_column < end && !join(*same, open)) {
        ++same;
      }
      if (same != parts_.end() && same->cells.first_row < row_) {
        joined_.insert(joined_.end(), next, same + 1);
        next = same + 1;
      } else {
        emit_(open.cells);
      }
    }
    joined_.insert(joined_.end(), next, parts_.end());
    std::sort(joined_.begin(), joined_.end());
    std::swap(open_, joined_);
    parts_.clear();
  }

  // Makes both one where that is as high nowhere else than over cells that are.
  bool join(Part& part, const Part& open) const {
    const CellRectangle<double>& before = open.cells;
    const long first = std::min(part.cells.first_column, before.first_column);
    const long last = std::max(part.cells.last_column, before.last_column);
    if (part.wide || open.wide) {
      if (!part.wide || !open.wide || first != part.cells.first_column ||
          first != before.first_column || last != part.cells.last_column ||
          last != before.last_column) {
        return false;
      }
    } else if (first < std::max(part.low, open.low) || last > std::min(part.high, open.high) ||
               last - first > most_columns_ || row_ + 1 - before.first_row > most_rows_) {
      return false;
    }
    part.low = std::max(part.low, open.low);
    part.high = std::min(part.high, open.high);
    part.cells = {first, last, before.first_row, row_ + 1, part.cells.value};
    return true;
  }

  Emit emit_;
  long most_columns_;
  long most_rows_;
  long row_ = 0;
  std::vector<Part> stretches_;  // of this row up to some column, each higher than the one before
  std::vector<Part> parts_;      // of this row
  std::vector<Part> open_;       // of the rows before
  std::vector<Part> joined_;
};

}  // namespace geom
