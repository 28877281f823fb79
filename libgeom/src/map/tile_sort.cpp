#include "tile_sort.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

#include "base/radix_sort.h"
#include "base/spread_sort.h"
#include "geom/base/in_order.h"
#include "geom/base/parallel.h"
#include "tile_order.h"

namespace geom {
namespace {

constexpr std::size_t kStretch = std::size_t{1} << 15;  // boxes that a thread takes at once
constexpr std::size_t kLongest = std::size_t{1} << 17;  // more boxes than these are never copied

constexpr std::size_t kAhead = 16;  // boxes

// The squares that boxes begin in, and a number for each of them: by column, then by row. The large
// boxes that begin in a column have a number of their own, before the squares of the column.
struct Squares {
  static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  double size;  // of a tile
  std::int32_t x0 = kMost, x1 = -kMost;
  std::int32_t y0 = kMost, y1 = -kMost;

  void add(const Aabb& box) {
    const std::int32_t ix = cell(box.min.x(), size);
    const std::int32_t iy = cell(box.min.y(), size);
    x0 = std::min(x0, ix), x1 = std::max(x1, ix);
    y0 = std::min(y0, iy), y1 = std::max(y1, iy);
  }
  void add(const Squares& other) {
    x0 = std::min(x0, other.x0), x1 = std::max(x1, other.x1);
    y0 = std::min(y0, other.y0), y1 = std::max(y1, other.y1);
  }
  std::uint64_t across() const { return static_cast<std::uint64_t>(std::int64_t{x1} - x0 + 1); }
  std::uint64_t in_column() const { return static_cast<std::uint64_t>(std::int64_t{y1} - y0 + 2); }
  std::uint64_t last() const { return x0 > x1 ? 0 : across() * in_column() - 1; }

  std::uint64_t number_of(const Aabb& box) const {
    const Place place = place_of(box, size);
    const std::int32_t ix = place.small ? place.ix : cell(box.min.x(), size);
    const std::uint64_t first = static_cast<std::uint64_t>(std::int64_t{ix} - x0) * in_column();
    return place.small ? first + 1 + static_cast<std::uint64_t>(std::int64_t{place.iy} - y0)
                       : first;
  }
  std::uint64_t column_of(std::uint64_t number) const { return number / in_column(); }
  bool is_large(std::uint64_t number) const { return number % in_column() == 0; }
  Tile tile(std::uint64_t number) const {
    if (is_large(number)) return {0, 0, true, {}, 0, 0};
    const auto column = static_cast<std::int64_t>(column_of(number));
    const auto row = static_cast<std::int64_t>(number % in_column()) - 1;
    return {static_cast<std::int32_t>(x0 + column),
            static_cast<std::int32_t>(y0 + row),
            false,
            {},
            0,
            0};
  }
  // Its place in the order of a map's tiles: the large one, then by row, then by column.
  std::uint64_t rank(std::uint64_t number) const {
    return is_large(number) ? 0 : 1 + (number % in_column() - 1) * across() + column_of(number);
  }
};

// Calls f(stretch, begin, end) for stretches of n items, on all threads.
template <class F>
void for_stretches(std::size_t n, const Execution& run, const F& f) {
  parallel_for((n + kStretch - 1) / kStretch, {run.threads, {}},
               [&](std::size_t s) { f(s, s * kStretch, std::min(n, (s + 1) * kStretch)); });
}

Squares squares_of(const BoxTable& table, double size, const Execution& run) {
  const std::size_t n = table.boxes.size();
  std::vector<Squares> parts(n / kStretch + 1, Squares{size});
  for_stretches(n, run, [&](std::size_t s, std::size_t begin, std::size_t end) {
    Squares part{size};
    for (std::size_t i = begin; i < end; ++i) part.add(table.boxes[i]);
    parts[s] = part;
  });
  Squares all{size};
  for (const Squares& part : parts) all.add(part);
  return all;
}

// The boxes of a tile that begin in one column of squares: all of them, but for the large ones.
struct Piece {
  std::uint64_t number;  // of the square
  std::size_t first;     // in the order of the squares
  std::size_t count = 0;
  std::size_t tile = 0;
  std::size_t next = 0;  // where the next of its boxes goes in the map
  Aabb extent;
};

// Puts the boxes of a table into their tiles. Number: what can count the boxes and the squares.
template <class Number>
class TileSorter {
 public:
  TileSorter(const BoxTable& table, const Squares& squares, const Execution& run)
      : table_(table), squares_(squares), run_(run), order_(by_square()) {
    find_pieces();
    find_tiles();
  }

  SortedBoxes sorted(const TakeBoxes& take) {
    own_ = std::make_shared<BoxMap::Data::Owned>(table_.boxes.size());
    std::vector<Part> spare;
    std::mutex guard;
    std::size_t piece = 0;
    const auto next = [&]() -> std::optional<Part> {
      if (piece == pieces_.size()) return std::nullopt;
      Part part;
      {
        const std::lock_guard lock(guard);
        if (!spare.empty()) part = std::move(spare.back()), spare.pop_back();
      }
      part.order = next_columns(piece);
      return part;
    };
    const auto give = [&](Part& part) {
      this->give(part, take);
      const std::lock_guard lock(guard);
      spare.push_back(std::move(part));
    };
    const Execution run = for_work(run_, table_.boxes.size(), kStretch);
    in_order<Part>(
        run, 2 * run.threads, next, [&](Part& part) { fill(part); }, give);
    return finished();
  }

 private:
  struct Placed {
    double x;  // its lower one
    Number box;
    Number piece;
  };
  struct Timed {
    std::uint64_t box;
    TimeSpan time;
  };
  // Whole columns of squares that follow each other. Its memory is used again.
  struct Part {
    std::span<Keyed<Number>> order;
    std::vector<Placed> placed;
    std::vector<Aabb> boxes;  // in order, unless they are too many
    std::vector<Timed> timed;
  };

  // The boxes of the table by the number of their square.
  LargeArray<Keyed<Number>> by_square() const {
    LargeArray<Keyed<Number>> keyed(table_.boxes.size());
    for_stretches(table_.boxes.size(), run_, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        keyed.all()[i] = {static_cast<Number>(squares_.number_of(table_.boxes[i])),
                          static_cast<Number>(i)};
      }
    });
    return radix_sorted(std::move(keyed), squares_.last(), run_);
  }

  // From here on the key of a box is its piece.
  void find_pieces() {
    const std::span<Keyed<Number>> order = order_.all();
    const auto begins_piece = [&](std::size_t i) {
      return i == 0 || order[i].key != order[i - 1].key;
    };
    // Of each stretch: how many pieces begin before its end, and whether one begins with it.
    std::vector<std::size_t> begun((order.size() + kStretch - 1) / kStretch);
    std::vector<std::uint8_t> begins(begun.size());
    for_stretches(order.size(), run_, [&](std::size_t s, std::size_t begin, std::size_t end) {
      begins[s] = begins_piece(begin);
      for (std::size_t i = begin; i < end; ++i) begun[s] += begins_piece(i);
    });
    std::partial_sum(begun.begin(), begun.end(), begun.begin());
    pieces_.resize(begun.empty() ? 0 : begun.back());
    for_stretches(order.size(), run_, [&](std::size_t s, std::size_t begin, std::size_t end) {
      std::size_t piece = s == 0 ? 0 : begun[s - 1];  // that begins next
      Number key = order[begin].key;
      for (std::size_t i = begin; i < end; ++i) {
        if (i == begin ? begins[s] : order[i].key != key) {
          key = order[i].key;
          pieces_[piece++] = {key, i, 0, 0, 0, table_.boxes[order[i].item]};
        }
        order[i].key = static_cast<Number>(piece - 1);
      }
    });
    std::size_t end = order.size();
    for (Piece& piece : std::views::reverse(pieces_)) {
      piece.count = end - piece.first;
      end = piece.first;
    }
  }

  void find_tiles() {
    LargeArray<Keyed<std::uint64_t>> ranked(pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      ranked.all()[p] = {squares_.rank(pieces_[p].number), p};
    }
    ranked = radix_sorted(std::move(ranked), squares_.last() + 1, run_);
    std::size_t next = 0;
    for (const auto& [rank, p] : ranked.all()) {
      Piece& piece = pieces_[p];
      if (tiles_.empty() || rank > 0) {
        tiles_.push_back(squares_.tile(piece.number));
        tiles_.back().first = next;
      }
      piece.tile = tiles_.size() - 1;
      piece.next = next;
      tiles_.back().count += piece.count;
      next += piece.count;
    }
  }

  // The boxes of whole columns, from `piece` on, until there are about kStretch. `piece` becomes
  // the first one behind them.
  std::span<Keyed<Number>> next_columns(std::size_t& piece) {
    const std::size_t first = pieces_[piece].first;
    std::size_t count = 0;
    const auto column = [&](std::size_t p) { return squares_.column_of(pieces_[p].number); };
    do {
      count += pieces_[piece++].count;
    } while (piece < pieces_.size() && (count < kStretch || column(piece) == column(piece - 1)));
    return order_.all().subspan(first, count);
  }

  bool comes_first(std::size_t a, std::size_t b) const {
    const Aabb& one = table_.boxes[a];
    const Aabb& other = table_.boxes[b];
    if (!(one == other)) return comes_before(one, other);
    if (table_.ids[a] != table_.ids[b]) return table_.ids[a] < table_.ids[b];
    if (const auto times = table_.time(a) <=> table_.time(b); times != 0) return times < 0;
    return a < b;
  }

  // Asks for a box that is needed soon. It may stand anywhere in the table.
  void fetch(std::size_t box) const {
    __builtin_prefetch(&table_.boxes[box]);
    __builtin_prefetch(&table_.ids[box]);
  }

  // Sorts a part, and writes its boxes to their places in the map.
  void fill(Part& part) {
    part.placed.clear();
    part.boxes.clear();
    part.timed.clear();
    for (std::size_t i = 0; i < part.order.size(); ++i) {
      const auto& [piece, box] = part.order[i];
      if (i + kAhead < part.order.size()) fetch(part.order[i + kAhead].item);
      part.placed.push_back({table_.boxes[box].min.x(), box, piece});
    }
    spread_sort(part.placed, [&](const Placed& a, const Placed& b) {
      return a.x != b.x ? a.x < b.x : comes_first(a.box, b.box);
    });
    const bool copies = part.order.size() <= kLongest;
    for (std::size_t i = 0; i < part.order.size(); ++i) {
      if (i + kAhead < part.order.size()) fetch(part.placed[i + kAhead].box);
      part.order[i].item = part.placed[i].box;
      const Aabb box = place(part.placed[i], part.timed);
      if (copies) part.boxes.push_back(box);
    }
  }

  Aabb place(const Placed& placed, std::vector<Timed>& timed) {
    Piece& piece = pieces_[placed.piece];
    const std::size_t to = piece.next++;
    const Aabb box = canonical(table_.boxes[placed.box]);
    own_->boxes.all()[to] = box;
    own_->ids.all()[to] = table_.ids[placed.box];
    own_->label.all()[to] = table_.label[placed.box];
    piece.extent = merged(piece.extent, box);
    if (placed.box < table_.times.size()) {
      const TimeSpan time = canonical(table_.times[placed.box]);
      if (!time.always()) timed.push_back({to, time});
    }
    return box;
  }

  void give(Part& part, const TakeBoxes& take) {
    timed_.insert(timed_.end(), part.timed.begin(), part.timed.end());
    if (!part.boxes.empty()) return take(part.boxes);
    for (std::size_t begin = 0; begin < part.order.size(); begin += kStretch) {
      part.boxes.clear();
      for (const auto& at :
           part.order.subspan(begin, std::min(kStretch, part.order.size() - begin))) {
        part.boxes.push_back(canonical(table_.boxes[at.item]));
      }
      take(part.boxes);
    }
  }

  SortedBoxes finished() {
    for (Piece& piece : pieces_) {
      Tile& tile = tiles_[piece.tile];
      const bool first = piece.next == tile.first + piece.count;
      tile.extent = canonical(first ? piece.extent : merged(tile.extent, piece.extent));
    }
    std::sort(timed_.begin(), timed_.end(),
              [](const Timed& a, const Timed& b) { return a.box < b.box; });
    for (const Timed& timed : timed_) {
      own_->timed.push_back(timed.box);
      own_->times.push_back(timed.time);
    }
    return {std::move(tiles_), own_};
  }

  const BoxTable& table_;
  const Squares& squares_;
  const Execution& run_;
  LargeArray<Keyed<Number>> order_;
  std::vector<Piece> pieces_;
  std::vector<Tile> tiles_;
  std::shared_ptr<BoxMap::Data::Owned> own_;
  std::vector<Timed> timed_;
};

}  // namespace

SortedBoxes sorted_by_tile(const BoxTable& table, double tile_size, const Execution& run,
                           const TakeBoxes& take) {
  const Squares squares = squares_of(table, tile_size, run);
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const bool few = squares.last() <= kMost && table.boxes.size() <= kMost;
  return few ? TileSorter<std::uint32_t>(table, squares, run).sorted(take)
             : TileSorter<std::uint64_t>(table, squares, run).sorted(take);
}

}  // namespace geom
