#include "column_shard.h"

#include <algorithm>

namespace geom {
namespace {

bool holds(const HeightSpan& known, const HeightSpan& span) {
  return static_cast<int>(known.low <= span.low) & static_cast<int>(span.high <= known.high);
}

// Whether one of the spans in place holds this span already. Nearly always one does. A column with
// a list may have old spans in place. Its list holds these, too, because spans only grow.
bool is_known(const ColumnShard::Column& column, const HeightSpan& span) {
  return static_cast<int>(holds(column.few[0], span)) |
         static_cast<int>(holds(column.few[1], span));
}

bool is_near(const HeightSpan& a, const HeightSpan& b, std::int64_t gap) {
  return static_cast<std::int64_t>(a.low) - b.high <= gap &&
         static_cast<std::int64_t>(b.low) - a.high <= gap;
}

}  // namespace

// The cells of a large cloud are all over memory: each is asked for well before it is changed.
void ColumnShard::add(std::span<const CellSpan> spans, std::int64_t gap) {
  constexpr std::size_t kAhead = 64;
  std::array<Column*, kAhead> asked;
  for (std::size_t i = 0; i < spans.size() + kAhead; ++i) {
    Column*& column = asked[i % kAhead];
    if (i >= kAhead) {
      const HeightSpan& span = spans[i - kAhead].span;
      if (!is_known(*column, span)) settle(*column, span, gap);
    }
    if (i < spans.size()) {
      column = &tiles_.at(spans[i].x, spans[i].y);
      __builtin_prefetch(column, 1);
      __builtin_prefetch(column->few.data() + 1, 1);  // perhaps in the next line of the cache
    }
  }
}

// Most columns have one span or two. If the new span is near to exactly one of them, that one
// grows. It stays further than the gap from the other.
void ColumnShard::settle(Column& column, const HeightSpan& span, std::int64_t gap) {
  HeightSpan* known = nullptr;
  if (column.count == 0) {
    column.few[0] = span;
    column.count = 1;
    return;
  }
  const bool first = is_near(column.few[0], span, gap);
  if (column.count == 1 && first) known = &column.few[0];
  if (column.count == 2 && first != is_near(column.few[1], span, gap)) {
    known = &column.few[first ? 0 : 1];
  }
  if (!known) return merge_into(column, span, gap);
  *known = {std::min(known->low, span.low), std::max(known->high, span.high)};
}

void ColumnShard::merge_into(Column& column, const HeightSpan& span, std::int64_t gap) {
  const HeightSpans known = spans_of(column);
  if (std::any_of(known.begin(), known.end(),
                  [&](const HeightSpan& s) { return holds(s, span); })) {
    return;
  }
  merged_.assign(known.begin(), known.end());
  const auto near = [&](const HeightSpan& s) { return is_near(s, span, gap); };
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
