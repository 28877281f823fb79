#include "hash.h"

#include <algorithm>
#include <vector>

#include "base/spread_sort.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"
#include "geom/base/sha256.h"
#include "tile_order.h"

namespace geom {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 17;  // boxes that are copied and merged at once
constexpr std::size_t kLongest = 8 * kWindow;          // a column beyond it is never held
constexpr std::size_t kTrim = 16;  // tiles that are copied before their pages are given back

// Boxes in order, and the first of them.
class Run {
 public:
  explicit Run(std::span<const Aabb> boxes) : boxes_(boxes), x_(boxes.front().min.x()) {}

  const Aabb& first() const { return boxes_.front(); }
  bool drop_first() {  // false where that was the last
    boxes_ = boxes_.subspan(1);
    if (boxes_.empty()) return false;
    x_ = boxes_.front().min.x();
    return true;
  }
  friend bool operator<(const Run& a, const Run& b) {
    return a.x_ != b.x_ ? a.x_ < b.x_ : comes_before(a.first(), b.first());
  }

 private:
  std::span<const Aabb> boxes_;
  double x_;
};

// Lets heap[i] sink to where both of what is below it do not come before it.
void sink(std::vector<Run>& heap, std::size_t i) {
  while (true) {
    std::size_t next = 2 * i + 1;
    if (next >= heap.size()) return;
    if (next + 1 < heap.size() && heap[next + 1] < heap[next]) ++next;
    if (!(heap[next] < heap[i])) return;
    std::swap(heap[i], heap[next]);
    i = next;
  }
}

// Tiles of one column of squares, and the large boxes that begin there or since the column before:
// all of them come after all boxes of the column before.
struct Column {
  std::vector<std::span<const Aabb>> parts;  // each in order
  std::size_t boxes = 0;

  void add(std::span<const Aabb> some) {
    if (some.empty()) return;
    parts.push_back(some);
    boxes += some.size();
  }
};

// Calls f(box) for the boxes of a column, in order, which takes no memory.
template <class F>
void merge(const Column& column, const F& f) {
  std::vector<Run> heap(column.parts.begin(), column.parts.end());
  for (std::size_t i = heap.size() / 2; i-- > 0;) sink(heap, i);
  while (!heap.empty()) {
    f(canonical(heap.front().first()));
    if (!heap.front().drop_first()) {
      heap.front() = heap.back();
      heap.pop_back();
    }
    sink(heap, 0);
  }
}

// The boxes of a column that is held, in order. Its parts follow each other along y, so those of
// one x are mostly in order already.
std::vector<Aabb> boxes_in_order(const Column& column) {
  struct At {
    double x;
    const Aabb* box;
  };
  std::vector<At> order;
  order.reserve(column.boxes);
  for (const auto& part : column.parts) {
    for (const Aabb& box : part) order.push_back({box.min.x(), &box});
  }
  spread_sort(order, [](const At& a, const At& b) {
    return a.x != b.x ? a.x < b.x : comes_before(*a.box, *b.box);
  });
  std::vector<Aabb> out;
  out.reserve(column.boxes);
  for (const At& at : order) out.push_back(canonical(*at.box));
  return out;
}

std::vector<Column> columns_of(double size, std::span<const Tile> tiles,
                               std::span<const Aabb> boxes) {
  std::span<const Aabb> large;
  if (!tiles.empty() && tiles.front().large) {
    large = boxes.first(tiles.front().count);
    tiles = tiles.subspan(1);
  }
  std::vector<const Tile*> by_column;
  for (const Tile& tile : tiles) by_column.push_back(&tile);
  std::stable_sort(by_column.begin(), by_column.end(),
                   [](const Tile* a, const Tile* b) { return a->ix < b->ix; });
  std::vector<Column> columns;
  for (std::size_t i = 0; i < by_column.size(); ++i) {
    const std::int32_t ix = by_column[i]->ix;
    if (i == 0 || ix != by_column[i - 1]->ix) {
      const auto beyond = std::partition_point(
          large.begin(), large.end(), [&](const Aabb& b) { return cell(b.min.x(), size) <= ix; });
      const auto here = static_cast<std::size_t>(beyond - large.begin());
      columns.emplace_back().add(large.first(here));
      large = large.subspan(here);
    }
    columns.back().add(boxes.subspan(by_column[i]->first, by_column[i]->count));
  }
  columns.emplace_back().add(large);
  return columns;
}

// One that is too long to be held.
void add_streamed(MapHash& sum, const Column& column) {
  constexpr std::size_t kPart = std::size_t{1} << 14;
  std::vector<Aabb> part;
  merge(column, [&](const Aabb& box) {
    part.push_back(box);
    if (part.size() < kPart) return;
    sum.add(part);
    part.clear();
    trim_mapped_files();
  });
  sum.add(part);
}

// Columns, copied out of a mapped file in its order: sorted where they are, they would keep
// pages from all over it in memory.
struct Window {
  std::vector<Aabb> boxes;
  std::vector<Column> columns;  // of these boxes, or of the map's own where those are in memory
};

Window copied(std::span<const Column> columns) {
  struct Part {
    std::span<const Aabb> boxes;
    std::size_t column;
  };
  std::vector<Part> parts;
  std::size_t count = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const auto& part : columns[c].parts) parts.push_back({part, c});
    count += columns[c].boxes;
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.boxes.data() < b.boxes.data(); });
  Window window;
  window.boxes.resize(count);
  window.columns.resize(columns.size());
  std::size_t at = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto to = std::span(window.boxes).subspan(at, parts[i].boxes.size());
    std::copy(parts[i].boxes.begin(), parts[i].boxes.end(), to.begin());
    window.columns[parts[i].column].add(to);
    at += to.size();
    if (i % kTrim == 0) trim_mapped_files();
  }
  return window;
}

Window window_of(std::span<const Column> columns, bool is_mapped) {
  return is_mapped ? copied(columns) : Window{{}, {columns.begin(), columns.end()}};
}

// How many of the columns make the first window; 0 where the first is too long to be held.
std::size_t window_size(std::span<const Column> columns) {
  if (columns.empty() || columns.front().boxes > kLongest) return 0;
  std::size_t count = 1;
  std::size_t boxes = columns.front().boxes;
  while (count < columns.size() && boxes + columns[count].boxes <= kWindow) {
    boxes += columns[count++].boxes;
  }
  return count;
}

// A window goes through three hands, taken, sorted and summed, and each window through another at
// the same time.
void add_boxes(MapHash& sum, std::span<const Column> columns, bool is_mapped,
               const Execution& run) {
  Window taken;
  std::vector<std::vector<Aabb>> ready;
  while (!columns.empty() || !taken.columns.empty() || !ready.empty()) {
    const std::size_t next = window_size(columns);
    if (next == 0 && taken.columns.empty() && ready.empty()) {
      add_streamed(sum, columns.front());
      columns = columns.subspan(1);
      continue;
    }
    Window fresh;
    std::vector<std::vector<Aabb>> sorted(taken.columns.size());
    parallel_for(sorted.size() + 2, {run.threads, {}}, [&](std::size_t i) {
      if (i == 0) {
        for (const auto& some : ready) sum.add(some);
      } else if (i == 1) {
        fresh = window_of(columns.first(next), is_mapped);
      } else {
        sorted[i - 2] = boxes_in_order(taken.columns[i - 2]);
      }
    });
    columns = columns.subspan(next);
    taken = std::move(fresh);
    ready = std::move(sorted);
  }
}

// Once more, with their times, by box and then by time.
void add_timed(Sha256& sum, std::span<const Aabb> boxes, const TimedBoxes& timed) {
  struct Entry {
    Aabb box;
    TimeSpan time;
  };
  static_assert(sizeof(Entry) == 8 * sizeof(double));
  std::vector<Entry> entries;
  entries.reserve(timed.box.size());
  for (std::size_t k = 0; k < timed.box.size(); ++k) {
    entries.push_back({canonical(boxes[timed.box[k]]), canonical(timed.time[k])});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    if (!(a.box == b.box)) return comes_before(a.box, b.box);
    return a.time < b.time;
  });
  sum.update(std::as_bytes(std::span(entries)));
}

}  // namespace

MapHash::MapHash(const BoxMapSpec& spec, std::size_t timed) {
  if (timed > 0) {
    const std::string times =
        "timed\n" + std::to_string(timed) + '\n' + spec.epoch.value_or("") + '\n';
    sum_.update(std::as_bytes(std::span(times)));
  }
  const std::string head = std::string(name(spec.frame.axes)) + '\n' + spec.frame.crs + '\n';
  sum_.update(std::as_bytes(std::span(head)));
  if (spec.frame.origin) {
    const double origin[] = {spec.frame.origin->latitude, spec.frame.origin->longitude,
                             spec.frame.origin->height};
    sum_.update(std::as_bytes(std::span(origin)));
  }
  const Aabb bounds = canonical(spec.bounds);
  add(std::span(&bounds, 1));
}

std::string MapHash::text(std::span<const Aabb> boxes, const TimedBoxes& timed) {
  add_timed(sum_, boxes, timed);
  return "sha256:" + sum_.hex();
}

std::string hash_of(const BoxMapSpec& spec, std::span<const Tile> tiles,
                    std::span<const Aabb> boxes, const TimedBoxes& timed, const Execution& run) {
  MapHash sum(spec, timed.box.size());
  const bool is_mapped = mapped_file_at(boxes.data()) != nullptr;
  add_boxes(sum, columns_of(spec.tile_size, tiles, boxes), is_mapped, run);
  return sum.text(boxes, timed);
}

}  // namespace geom
