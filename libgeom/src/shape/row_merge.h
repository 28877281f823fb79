#pragma once

// Cells of a grid, row by row, as few rectangles of equal value.

#include <utility>
#include <vector>

namespace geom {

// Cells [first_column, last_column) x [first_row, last_row) of one value.
template <class Value>
struct CellRectangle {
  long first_column = 0;
  long last_column = 0;
  long first_row = 0;
  long last_row = 0;
  Value value{};
};

// Of values that count as one only where they are equal.
struct JoinEqual {
  template <class Value>
  bool operator()(const Value& into, const Value& other) const {
    return into == other;
  }
};

// Takes cells by ascending row, in a row by ascending column; calls `emit` for each rectangle once
// it can grow no more. Runs of equal neighbours in a row grow while the next row repeats them
// exactly. Memory: two rows.
//
// Another `Join` may let values differ: join(into, other) says whether both can be one, which it
// then makes of `into`; else it leaves it alone.
template <class Value, class Emit, class Join = JoinEqual>
class RowMerge {
 public:
  explicit RowMerge(Emit emit, Join join = {}) : emit_(std::move(emit)), join_(std::move(join)) {}

  void add(long row, long column, const Value& value) { add(row, column, column + 1, value); }

  // The cells [first, last) of a row.
  void add(long row, long first, long last, const Value& value) {
    if (row != row_) finish_row(row);
    if (!runs_.empty() && runs_.back().last_column == first && join_(runs_.back().value, value)) {
      runs_.back().last_column = last;
    } else {
      runs_.push_back({first, last, row, row + 1, value});
    }
  }

  void finish() {
    finish_row(row_ + 2);  // a row that continues nothing
    open_.clear();
  }

 private:
  using Run = CellRectangle<Value>;

  void finish_row(long next_row) {
    std::size_t next = 0;
    for (const Run& open : open_) {
      while (next < runs_.size() && runs_[next].first_column < open.first_column) ++next;
      Run* same = next < runs_.size() ? &runs_[next] : nullptr;
      if (same && open.last_row == row_ && same->first_column == open.first_column &&
          same->last_column == open.last_column && join_(same->value, open.value)) {
        same->first_row = open.first_row;
      } else {
        emit_(open);
      }
    }
    open_ = std::move(runs_);
    runs_.clear();
    if (next_row != row_ + 1) {
      for (const Run& open : open_) emit_(open);
      open_.clear();
    }
    row_ = next_row;
  }

  Emit emit_;
  Join join_;
  long row_ = 0;
  std::vector<Run> runs_;  // of this row
  std::vector<Run> open_;  // of the row before
};

}  // namespace geom
