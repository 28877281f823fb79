#include "column_shard.h"

#include <algorithm>

namespace geom {

// The cells of a large cloud are all over memory: a few are asked for at once, and then changed.
void ColumnShard::add(std::span<const CellSpan> spans, std::int64_t gap) {
  constexpr std::size_t kAtOnce = 16;
  std::array<Column*, kAtOnce> columns;
  while (!spans.empty()) {
    const std::span<const CellSpan> some = spans.first(std::min(kAtOnce, spans.size()));
    for (std::size_t i = 0; i < some.size(); ++i) {
      columns[i] = &tiles_.at(some[i].x, some[i].y);
      __builtin_prefetch(columns[i], 1);
    }
    for (std::size_t i = 0; i < some.size(); ++i) settle(*columns[i], some[i].span, gap);
    spans = spans.subspan(some.size());
  }
}

void ColumnShard::settle(Column& column, const HeightSpan& span, std::int64_t gap) {
  for (const HeightSpan& known : spans_of(column)) {
    if (known.low <= span.low && span.high <= known.high) return;
  }
  merge_into(column, span, gap);
}

void ColumnShard::merge_into(Column& column, const HeightSpan& span, std::int64_t gap) {
  const HeightSpans known = spans_of(column);
  merged_.assign(known.begin(), known.end());
  const auto near = [&](const HeightSpan& s) {
    return static_cast<std::int64_t>(s.low) - span.high <= gap &&
           static_cast<std::int64_t>(span.low) - s.high <= gap;
  };
  // What is near is consecutive; it and the new one become one, which may reach no others: those
  // are further from it than the gap, or would be near themselves.
  const auto first = std::find_if(merged_.begin(), merged_.end(), near);
  if (first == merged_.end()) {
    merged_.insert(std::find_if(merged_.begin(), merged_.end(),
                                [&](const HeightSpan& s) { return s.low > span.high; }),
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

}  // namespace geom
