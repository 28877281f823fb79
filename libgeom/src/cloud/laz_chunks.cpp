#include "laz_chunks.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "integer_decoder.h"
#include "laz_chunk.h"

namespace geom {
namespace {

struct Chunk {
  std::uint64_t points = 0;
  std::uint64_t bytes = 0;
};

using Layout = LazSetup::Layout;

// The table at the place of `bytes`: sizes, and points where chunks vary. It must have `chunks`
// entries, or at most so many.
std::vector<Chunk> read_table(ByteSource& bytes, bool with_points, std::uint64_t chunks,
                              bool at_most) {
  if (const auto version = bytes.number<std::uint32_t>(); version != 0) {
    bytes.refuse({.expected = "a table of chunks of version 0", .found = fmt::to_string(version)});
  }
  const std::uint64_t count = bytes.number<std::uint32_t>();
  if (at_most ? count > chunks : count != chunks) {
    bytes.refuse(
        {.says = fmt::format("its table of chunks has {} entries, and its points take {}{}", count,
                             at_most ? "at most " : "", chunks)});
  }
  std::vector<Chunk> table;
  if (count == 0) return table;
  RangeDecoder code(bytes);
  IntegerDecoder number(32, 2);
  Chunk last;
  const auto next = [&](std::uint64_t before, unsigned context) -> std::uint64_t {
    return static_cast<std::uint32_t>(
        number.next(code, static_cast<std::int32_t>(static_cast<std::uint32_t>(before)), context));
  };
  for (std::uint64_t i = 0; i < count; ++i) {
    if (with_points) last.points = next(last.points, 0);
    last.bytes = next(last.bytes, 1);
    table.push_back(last);
  }
  code.require_end();
  return table;
}

// Where the table is, as the eight bytes before the first chunk say. A writer that could not go
// back to them left no place there, and wrote it after the table.
class TablePlace {
 public:
  explicit TablePlace(ByteSource& bytes) : place_(bytes.number<std::int64_t>()) {}

  bool at_end() const { return place_ <= 0; }
  std::uint64_t place() const { return static_cast<std::uint64_t>(place_); }

  // The table must be here, where the chunks end, and agree with them.
  void require(ByteSource& bytes, bool with_points, const std::vector<Chunk>& found) const {
    const std::uint64_t here = bytes.position();
    if (!at_end() && place() != here) {
      bytes.refuse(
          {.says = fmt::format("its compressed points end at byte {}, and their table of chunks is "
                               "said to be at byte {}",
                               here, place_),
           .advice = "the file is damaged, or holds more or fewer points than its header says"});
    }
    const std::vector<Chunk> table = read_table(bytes, with_points, found.size(), false);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (table[i].bytes != found[i].bytes)
        differs(bytes, i, table[i].bytes, found[i].bytes, "bytes");
      if (with_points && table[i].points != found[i].points) {
        differs(bytes, i, table[i].points, found[i].points, "points");
      }
    }
    if (at_end()) require_place(bytes, here);
  }

 private:
  [[noreturn]] static void differs(ByteSource& bytes, std::size_t chunk, std::uint64_t told,
                                   std::uint64_t found, const char* of) {
    bytes.refuse(
        {.says = fmt::format("its table of chunks says that chunk {} has {} {}, and it has {}",
                             chunk, told, of, found)});
  }

  static void require_place(ByteSource& bytes, std::uint64_t here) {
    if (const auto told = bytes.number<std::uint64_t>(); told != here) {
      bytes.refuse({.expected = fmt::format("the place of the table of chunks, {}, after it", here),
                    .found = fmt::to_string(told)});
    }
  }

  std::int64_t place_;
};

// The points of each chunk, which only the table knows.
std::vector<Chunk> table_ahead(ByteSource& bytes, const TablePlace& place, const LazSetup& setup) {
  const std::uint64_t start = bytes.position();
  const std::span<const unsigned char> rest = bytes.load();
  std::uint64_t at = place.place();
  if (place.at_end() && rest.size() >= 8) {
    const std::span<const unsigned char> last = rest.last(8);
    at = ByteSource(last, 0, "").number<std::uint64_t>();
  }
  if (at < start || at - start >= rest.size()) {
    bytes.refuse({.expected = fmt::format("its table of chunks between bytes {} and {}", start,
                                          start + rest.size()),
                  .found = fmt::format("it at {}", at),
                  .advice = "the file is cut short or damaged"});
  }
  ByteSource ahead(rest.subspan(at - start), at, bytes.source());
  return read_table(ahead, true, rest.size() / setup.point_bytes, true);
}

// The table by the other way, of chunks of a fixed number of points; empty where it is not to be
// had, or is not what it can be. Then the chunks are read one after the other, and what is wrong
// with the file is found there.
std::vector<Chunk> table_told(const ReadAt& ahead, const TablePlace& place, const LazSetup& setup,
                              std::uint64_t start, std::uint64_t points) {
  constexpr std::uint64_t kMostPoints = 1U << 22;  // of a chunk whose code is held
  constexpr std::uint64_t kMostEntry = 8;          // bytes of a chunk in the table, generously
  constexpr std::uint64_t kMostChunks = 1U << 22;
  const std::uint64_t chunks = (points - 1) / setup.chunk_points + 1;
  if (!ahead || place.at_end() || setup.chunk_points > kMostPoints || chunks > kMostChunks)
    return {};
  std::vector<unsigned char> code(kMostEntry * (chunks + 4));
  code.resize(ahead(place.place(), code));
  std::vector<Chunk> table;
  try {
    ByteSource bytes(code, place.place(), "");
    table = read_table(bytes, false, chunks, false);
  } catch (const InputError&) {  // the one in its place will say what is wrong
    return {};
  }
  std::uint64_t end = start;
  for (Chunk& chunk : table) {
    chunk.points = std::min<std::uint64_t>(setup.chunk_points, points);
    points -= chunk.points;
    if (chunk.bytes > 1000 + 2 * chunk.points * setup.point_bytes) return {};  // no encoder's
    end += chunk.bytes;
  }
  return end == place.place() ? table : std::vector<Chunk>{};
}

class Reader {
 public:
  Reader(ByteSource& bytes, const LazSetup& setup, std::uint64_t points, const LasReading& reading,
         const LazPointSink& sink)
      : bytes_(bytes), setup_(setup), left_(points), run_(reading.run), sink_(sink), place_(bytes) {
    if (setup.layout != Layout::chunks) return;
    table_ = setup.chunks_vary()
                 ? table_ahead(bytes, place_, setup)
                 : table_told(reading.ahead, place_, setup, bytes.position(), points);
  }

  void run() {
    if (setup_.layout == Layout::layers || setup_.chunks_vary() || !table_.empty()) {
      read_on_all_threads();
    } else {
      read_one_by_one();
    }
    place_.require(bytes_, setup_.chunks_vary(), found_);
  }

 private:
  void read_one_by_one() {
    while (left_ > 0) {
      const std::uint64_t start = bytes_.position();
      const std::uint64_t count = std::min<std::uint64_t>(setup_.chunk_points, left_);
      read_laz_items(bytes_, setup_, count, sink_);
      add({count, bytes_.position() - start});
    }
  }

  void read_on_all_threads() {
    std::uint64_t most = setup_.chunks_vary() ? 0 : setup_.chunk_points;
    for (const Chunk& chunk : table_) most = std::max(most, chunk.points);
    const auto next = [&]() -> std::optional<LazChunk> {
      if (left_ == 0) return std::nullopt;
      LazChunk chunk = setup_.layout == Layout::layers ? layers() : items();
      add({chunk.points(), chunk.bytes()});
      return chunk;
    };
    in_order<LazChunk>(
        run_, laz_window(run_, most), next,
        [&](LazChunk& chunk) { chunk.decode(setup_, bytes_.source()); },
        [&](const LazChunk& chunk) { chunk.for_each(setup_, bytes_.source(), sink_); });
  }

  LazChunk layers() {
    const bool vary = setup_.chunks_vary();
    const std::uint64_t most = vary ? left_ : std::min<std::uint64_t>(setup_.chunk_points, left_);
    LazChunk chunk = LazChunk::of_layers(bytes_, setup_, most);
    if (!vary && chunk.points() != most) {
      bytes_.refuse({.says = fmt::format("expected a chunk of {} points, and it says {}", most,
                                         chunk.points())});
    }
    return chunk;
  }

  LazChunk items() {
    const std::size_t number = found_.size();
    const Chunk told = number < table_.size() ? table_[number] : Chunk();
    if (told.points == 0 || told.points > left_) {
      bytes_.refuse({.says = fmt::format(
                         "its table of chunks says that chunk {} has {} points, and {} are left",
                         number, told.points, left_)});
    }
    return LazChunk::of_items(bytes_, told.points, told.bytes);
  }

  void add(const Chunk& chunk) {
    left_ -= chunk.points;
    found_.push_back(chunk);
  }

  ByteSource& bytes_;
  const LazSetup& setup_;
  std::uint64_t left_;  // points
  const Execution& run_;
  const LazPointSink& sink_;
  TablePlace place_;
  std::vector<Chunk> table_;  // where it is known before the chunks
  std::vector<Chunk> found_;
};

}  // namespace

void for_each_laz_point(ByteSource& bytes, const LazSetup& setup, std::uint64_t points,
                        const LasReading& reading, const LazPointSink& sink) {
  if (points == 0) return;
  if (setup.layout == Layout::one_stream) return read_laz_items(bytes, setup, points, sink);
  Reader(bytes, setup, points, reading, sink).run();
}

}  // namespace geom
