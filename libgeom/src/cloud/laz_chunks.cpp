#include "laz_chunks.h"

#include <fmt/format.h>

#include <algorithm>

#include "integer_decoder.h"
#include "laz_items.h"
#include "laz_layers.h"

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
    bytes.refuse(fmt::format("expected a table of chunks of version 0, found {}", version));
  }
  const std::uint64_t count = bytes.number<std::uint32_t>();
  if (at_most ? count > chunks : count != chunks) {
    bytes.refuse(fmt::format("its table of chunks has {} entries, and its points take {}{}", count,
                             at_most ? "at most " : "", chunks));
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
          fmt::format("its compressed points end at byte {}, and their table of chunks is "
                      "said to be at byte {}: the file is damaged, or holds more or fewer "
                      "points than its header says",
                      here, place_));
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
    bytes.refuse(fmt::format("its table of chunks says that chunk {} has {} {}, and it has {}",
                             chunk, told, of, found));
  }

  static void require_place(ByteSource& bytes, std::uint64_t here) {
    if (const auto told = bytes.number<std::uint64_t>(); told != here) {
      bytes.refuse(fmt::format("expected the place of the table of chunks, {}, after it, found {}",
                               here, told));
    }
  }

  std::int64_t place_;
};

void read_items(ByteSource& bytes, const LazSetup& setup, std::uint64_t count,
                const LazPointSink& sink) {
  std::vector<unsigned char> first;
  bytes.read(setup.point_bytes, first);
  const auto items = laz_item_decoders(setup, first);
  LazPoint point = first_laz_point(setup, first);
  sink(point);
  RangeDecoder code(bytes);
  for (std::uint64_t i = 1; i < count; ++i) {
    for (const auto& item : items) item->next(code, point);
    sink(point);
  }
  code.require_end();
}

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
    bytes.refuse(
        fmt::format("expected its table of chunks between bytes {} and {}, found it at "
                    "{}: the file is cut short or damaged",
                    start, start + rest.size(), at));
  }
  ByteSource ahead(rest.subspan(at - start), at, bytes.source());
  return read_table(ahead, true, rest.size() / setup.point_bytes, true);
}

// Where the chunks' numbers of points come from.
class ChunkCounts {
 public:
  ChunkCounts(const LazSetup& setup, std::vector<Chunk> table)
      : setup_(setup), table_(std::move(table)) {}

  std::uint64_t of(ByteSource& bytes, std::size_t chunk, std::uint64_t left) const {
    if (!setup_.chunks_vary()) return std::min<std::uint64_t>(setup_.chunk_points, left);
    if (setup_.layout != Layout::chunks) return left;
    const std::uint64_t told = chunk < table_.size() ? table_[chunk].points : 0;
    if (told == 0 || told > left) {
      bytes.refuse(
          fmt::format("its table of chunks says that chunk {} has {} points, and {} are "
                      "left",
                      chunk, told, left));
    }
    return told;
  }

 private:
  const LazSetup& setup_;
  std::vector<Chunk> table_;
};

}  // namespace

void for_each_laz_point(ByteSource& bytes, const LazSetup& setup, std::uint64_t points,
                        const LazPointSink& sink) {
  if (points == 0) return;
  if (setup.layout == Layout::one_stream) return read_items(bytes, setup, points, sink);
  const TablePlace place(bytes);
  const bool vary = setup.chunks_vary();
  const ChunkCounts counts(setup, vary && setup.layout == Layout::chunks
                                      ? table_ahead(bytes, place, setup)
                                      : std::vector<Chunk>());
  std::vector<Chunk> found;
  for (std::uint64_t left = points; left > 0; left -= found.back().points) {
    const std::uint64_t start = bytes.position();
    std::uint64_t count = counts.of(bytes, found.size(), left);
    if (setup.layout == Layout::layers) {
      const std::uint64_t inside = read_laz_layers(bytes, setup, count, sink);
      if (!vary && inside != count) {
        bytes.refuse(fmt::format("expected a chunk of {} points, and it says {}", count, inside));
      }
      count = inside;
    } else {
      read_items(bytes, setup, count, sink);
    }
    found.push_back({count, bytes.position() - start});
  }
  place.require(bytes, vary, found);
}

}  // namespace geom
