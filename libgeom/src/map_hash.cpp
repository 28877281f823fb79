#include "map_hash.h"

#include <algorithm>
#include <vector>

#include "geom/mapped_file.h"
#include "geom/parallel.h"
#include "geom/sha256.h"
#include "tile_order.h"

namespace geom {
namespace {

// Boxes that are merged at once, before they are summed. What they are read from are pages of as
// many tiles as a column has, so that less would read each page again and again.
constexpr std::size_t kWindow = std::size_t{1} << 18;

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

// Calls f(box) for the boxes of all runs, in order.
template <class F>
void merge(std::vector<Run> heap, const F& f) {
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

// Tiles of one column of squares, and the large boxes that begin there or since the column before:
// all of them come after all boxes of the column before.
struct Column {
  std::vector<Run> runs;
  std::size_t boxes = 0;

  void add(std::span<const Aabb> some) {
    if (some.empty()) return;
    runs.emplace_back(some);
    boxes += some.size();
  }
};

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

void add(Sha256& sum, std::span<const Aabb> boxes) { sum.update(std::as_bytes(boxes)); }

// One that is too long to be held.
void add_streamed(Sha256& sum, const Column& column) {
  constexpr std::size_t kPart = std::size_t{1} << 14;
  std::vector<Aabb> part;
  merge(column.runs, [&](const Aabb& box) {
    part.push_back(box);
    if (part.size() < kPart) return;
    add(sum, part);
    part.clear();
    trim_mapped_files();
  });
  add(sum, part);
}

// Columns are merged on all threads while those before are summed.
void add_boxes(Sha256& sum, std::span<const Column> columns, const Execution& run) {
  std::vector<std::vector<Aabb>> ready;
  for (std::size_t begin = 0; begin < columns.size() || !ready.empty();) {
    std::size_t end = begin;
    std::size_t boxes = 0;
    while (end < columns.size() && boxes + columns[end].boxes <= kWindow) {
      boxes += columns[end++].boxes;
    }
    std::vector<std::vector<Aabb>> next(end - begin);
    parallel_for(next.size() + 1, {run.threads, {}}, [&](std::size_t i) {
      if (i == 0) {
        for (const auto& some : ready) add(sum, some);
        return;
      }
      const Column& column = columns[begin + i - 1];
      next[i - 1].reserve(column.boxes);
      merge(column.runs, [&](const Aabb& box) { next[i - 1].push_back(box); });
    });
    trim_mapped_files();
    ready = std::move(next);
    begin = end;
    if (ready.empty() && begin < columns.size()) add_streamed(sum, columns[begin++]);
  }
}

}  // namespace

std::string hash_of(const BoxMapSpec& spec, std::span<const Tile> tiles,
                    std::span<const Aabb> boxes, const Execution& run) {
  Sha256 sum;
  const std::string head = std::string(name(spec.frame.axes)) + '\n' + spec.frame.crs + '\n';
  sum.update(std::as_bytes(std::span(head)));
  if (spec.frame.origin) {
    const double origin[] = {spec.frame.origin->latitude, spec.frame.origin->longitude,
                             spec.frame.origin->height};
    sum.update(std::as_bytes(std::span(origin)));
  }
  const Aabb bounds = canonical(spec.bounds);
  sum.update(std::as_bytes(std::span(&bounds, 1)));
  add_boxes(sum, columns_of(spec.tile_size, tiles, boxes), run);
  return "sha256:" + sum.hex();
}

}  // namespace geom
