#include "block_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>

#include "geom/base/error.h"
#include "geom/base/parallel.h"

namespace plan {
namespace {

constexpr std::int64_t kSide = LatticeGrid::kSide;
constexpr std::size_t kBlock = LatticeGrid::kBlock;
constexpr std::int64_t kTile = 4;  // columns of blocks along the edge of what one thread does
constexpr std::uint32_t kFreeBit16 = 1u << kHalfDirections;

// kFree, kBlocked, or 0 for one that needs a record.
std::uint32_t classify(const LatticeGrid& grid, const Index3& low, const Lattice::Block& masks) {
  const std::uint32_t first = masks[0];
  const bool same = std::all_of(masks.begin(), masks.end(), [&](auto m) { return m == first; });
  if (same && first == 0) return BlockStore::kBlocked;
  if (grid.inside({low[0] - 1, low[1] - 1, low[2] - 1}, {kSide + 2, kSide + 2, kSide + 2})) {
    return same && first == (Lattice::kNode | grid.possible(low)) ? BlockStore::kFree : 0;
  }
  bool all = true;
  std::size_t n = 0;
  for (std::int64_t k = 0; k < kSide; ++k) {
    for (std::int64_t j = 0; j < kSide; ++j) {
      for (std::int64_t i = 0; i < kSide; ++i, ++n) {
        const Index3 node = {low[0] + i, low[1] + j, low[2] + k};
        all = all && (!grid.contains(node) || masks[n] == (Lattice::kNode | grid.possible(node)));
      }
    }
  }
  return all ? BlockStore::kFree : 0;
}

void append_record(Connectivity connectivity, const Lattice::Block& masks,
                   std::vector<std::byte>& out) {
  const auto free = [](std::uint32_t mask) { return mask >> 31; };
  if (connectivity == Connectivity::six) {
    for (std::size_t n = 0; n < kBlock; n += 2) {
      const auto nibble = [&](std::uint32_t mask) { return (mask & 7) | free(mask) << 3; };
      out.push_back(static_cast<std::byte>(nibble(masks[n]) | nibble(masks[n + 1]) << 4));
    }
    return;
  }
  for (const std::uint32_t mask : masks) {
    const std::uint32_t word = (mask & (kFreeBit16 - 1)) | free(mask) << kHalfDirections;
    out.push_back(static_cast<std::byte>(word & 0xff));
    out.push_back(static_cast<std::byte>(word >> 8));
  }
}

LatticeCounts count(const Lattice::Block& masks) {
  LatticeCounts counts;
  for (const std::uint32_t mask : masks) {
    counts.nodes += mask >> 31;
    counts.edges += static_cast<std::size_t>(std::popcount(mask & (kFreeBit16 - 1)));
  }
  return counts;
}

void add(LatticeCounts& counts, const LatticeCounts& more) {
  counts.nodes += more.nodes;
  counts.edges += more.edges;
}

struct Tile {
  std::vector<std::uint32_t> record;  // of its blocks
  std::vector<std::byte> records;
  LatticeCounts counts;
};

// How tiles lie on the grid.
class TileOrder {
 public:
  explicit TileOrder(const LatticeGrid& grid)
      : blocks_(grid.blocks()), across_((blocks_[0] + kTile - 1) / kTile) {}

  std::size_t count() const {
    return static_cast<std::size_t>(across_ * ((blocks_[1] + kTile - 1) / kTile));
  }

  // Calls f(block, its place among the blocks) in the order of a tile.
  template <class F>
  void for_each_block(std::size_t tile, const F& f) const {
    const std::int64_t x = static_cast<std::int64_t>(tile) % across_ * kTile;
    const std::int64_t y = static_cast<std::int64_t>(tile) / across_ * kTile;
    for (std::int64_t k = 0; k < blocks_[2]; ++k) {
      for (std::int64_t j = y; j < std::min(y + kTile, blocks_[1]); ++j) {
        for (std::int64_t i = x; i < std::min(x + kTile, blocks_[0]); ++i) {
          f(static_cast<std::size_t>(i + blocks_[0] * (j + blocks_[1] * k)), Index3{i, j, k});
        }
      }
    }
  }

 private:
  Index3 blocks_;
  std::int64_t across_;
};

Tile read_tile(const LatticeGrid& grid, const MaskSource& source, std::size_t number) {
  Tile tile;
  Lattice::Block masks;
  std::uint32_t records = 0;
  TileOrder(grid).for_each_block(number, [&](std::size_t, const Index3& place) {
    const Index3 low = {place[0] * kSide, place[1] * kSide, place[2] * kSide};
    source.read(low, {kSide, kSide, kSide}, masks.data());
    add(tile.counts, count(masks));
    std::uint32_t record = classify(grid, low, masks);
    if (record == 0) {
      record = records++;
      append_record(grid.spec.connectivity, masks, tile.records);
    }
    tile.record.push_back(record);
  });
  return tile;
}

// Grows in place where the system can move pages: a vector would hold two copies now and then.
class Bytes {
 public:
  void append(std::span<const std::byte> more) {
    if (size_ + more.size() > room_) {
      room_ = std::max(size_ + more.size(), 2 * room_);
      auto* const moved = static_cast<std::byte*>(std::realloc(at_.get(), room_));
      if (!moved) throw std::bad_alloc();
      static_cast<void>(at_.release());
      at_.reset(moved);
    }
    std::copy(more.begin(), more.end(), at_.get() + size_);
    size_ += more.size();
  }
  std::span<const std::byte> view() const { return {at_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::byte* at) const { std::free(at); }
  };
  std::unique_ptr<std::byte, Free> at_;
  std::size_t size_ = 0;
  std::size_t room_ = 0;
};

struct Owned {
  std::vector<std::uint32_t> record;
  Bytes records;
};

void require_numbers(std::size_t records) {
  if (records < BlockStore::kFree) return;
  throw geom::InputError("lattice",
                         {.expected = "less than 2^32 blocks that are not all free or blocked",
                          .advice = "use a larger spacing"});
}

[[noreturn]] void refuse_shard(std::size_t index, std::string_view what) {
  throw geom::InputError("lattice", {.says = fmt::format("shard {} {}", index + 1, what)});
}

}  // namespace

BlockStore::BlockStore(const LatticeGrid& grid, StoredBlocks blocks, std::string name)
    : grid_(grid), blocks_(std::move(blocks)), name_(std::move(name)) {
  if (blocks_.record.size() != grid_.block_count()) {
    refuse({.expected = fmt::format("{} blocks", grid_.block_count()),
            .found = fmt::to_string(blocks_.record.size())});
  }
  const std::size_t count = blocks_.records.size() / record_bytes(grid_.spec.connectivity);
  std::size_t stored = 0;
  for (std::size_t b = 0; b < blocks_.record.size(); ++b) {
    if (blocks_.record[b] >= kFree) continue;
    ++stored;
    if (blocks_.record[b] >= count) {
      refuse({.says = fmt::format("block {} has record {} of {}", b, blocks_.record[b], count)});
    }
  }
  if (stored != count) {
    refuse({.expected = fmt::format("a record for each of {} blocks", stored),
            .found = fmt::to_string(count)});
  }
}

void BlockStore::refuse(geom::Fault fault) const {
  throw geom::InputError(name_, std::move(fault));
}

std::uint32_t BlockStore::stored(std::uint32_t record, std::size_t local) const {
  const std::byte* const at =
      blocks_.records.data() + record * record_bytes(grid_.spec.connectivity);
  if (grid_.spec.connectivity == Connectivity::six) {
    const auto nibble = static_cast<std::uint32_t>(at[local / 2]) >> (4 * (local % 2)) & 15;
    return (nibble & 7) | (nibble & 8) << 28;
  }
  const auto word = static_cast<std::uint32_t>(at[2 * local]) |
                    static_cast<std::uint32_t>(at[2 * local + 1]) << 8;
  return (word & ~kFreeBit16) | (word & kFreeBit16) << (31 - kHalfDirections);
}

void BlockStore::read(const Index3& low, const Index3& count, std::uint32_t* masks) const {
  const Index3 n = grid_.blocks();
  std::uint32_t* out = masks;
  for (std::int64_t k = low[2]; k < low[2] + count[2]; ++k) {
    for (std::int64_t j = low[1]; j < low[1] + count[1]; ++j) {
      const bool outside = k < 0 || j < 0 || k >= grid_.dims[2] || j >= grid_.dims[1];
      for (std::int64_t i = low[0]; i < low[0] + count[0]; ++i, ++out) {
        *out = 0;
        if (outside || i < 0 || i >= grid_.dims[0]) continue;
        const auto block =
            static_cast<std::size_t>(i / kSide + n[0] * (j / kSide + n[1] * (k / kSide)));
        const std::uint32_t record = blocks_.record[block];
        if (record == kBlocked) continue;
        const std::uint32_t possible = grid_.possible({i, j, k});
        if (record == kFree) {
          *out = Lattice::kNode | possible;
          continue;
        }
        const auto local =
            static_cast<std::size_t>(i % kSide + kSide * (j % kSide + kSide * (k % kSide)));
        const std::uint32_t mask = stored(record, local);
        const std::uint32_t edges = mask & ~Lattice::kNode;
        if ((edges & ~possible) || (edges && !(mask & Lattice::kNode))) {
          refuse({.says = fmt::format("node {} of block {} has an edge that is impossible", local,
                                      block),
                  .advice = "the file is damaged"});
        }
        *out = mask;
      }
    }
  }
}

void BlockStore::check() const {
  for (std::size_t b = 0; b < blocks_.record.size(); ++b) {
    if (blocks_.record[b] >= kFree) continue;
    const Index3 low = grid_.block_low(b);
    for (std::size_t n = 0; n < kBlock; ++n) {
      const auto local = static_cast<std::int64_t>(n);
      const Index3 node = {low[0] + local % kSide, low[1] + local / kSide % kSide,
                           low[2] + local / (kSide * kSide)};
      if (!grid_.contains(node) && stored(blocks_.record[b], n)) {
        refuse(
            {.says = fmt::format("place {} of block {} is outside the lattice, but not 0", n, b)});
      }
    }
  }
}

StoredBlocks store_tiles(const LatticeGrid& grid, const MaskSource& source,
                         const geom::Execution& run, const geom::Shard& shard) {
  const std::size_t first = shard.begin(TileOrder(grid).count());
  const std::size_t total = shard.end(TileOrder(grid).count()) - first;
  const auto owned = std::make_shared<Owned>();
  LatticeCounts counts;
  std::size_t stored = 0;
  // Tile by tile, so that records need no second pass.
  constexpr std::size_t kSome = 64;
  for (std::size_t begin = 0; begin < total; begin += kSome) {
    const std::size_t some = std::min(kSome, total - begin);
    std::vector<Tile> tiles(some);
    geom::parallel_for(some, {run.threads, {}}, [&](std::size_t t) {
      tiles[t] = read_tile(grid, source, first + begin + t);
    });
    for (const Tile& tile : tiles) {
      for (const std::uint32_t record : tile.record) {
        const bool has_one = record < BlockStore::kFree;
        owned->record.push_back(has_one ? static_cast<std::uint32_t>(stored + record) : record);
      }
      owned->records.append(tile.records);
      stored = owned->records.view().size() / BlockStore::record_bytes(grid.spec.connectivity);
      require_numbers(stored);
      add(counts, tile.counts);
    }
    if (run.progress) run.progress(begin + some, total);
  }
  return {counts, owned->record, owned->records.view(), owned};
}

std::vector<StoredBlocks> tiles_of(std::span<const LatticePart> parts) {
  std::vector<StoredBlocks> tiles;
  for (const LatticePart& part : parts) {
    if (part.grid.first != parts.front().grid.first || part.grid.dims != parts.front().grid.dims) {
      throw geom::InputError(
          "lattice", {.says = fmt::format("shard {} is of another lattice", tiles.size() + 1)});
    }
    tiles.push_back(part.blocks);
  }
  return tiles;
}

JoinedTiles join_tiles(const LatticeGrid& grid, std::span<const StoredBlocks> shards) {
  const TileOrder order(grid);
  const std::size_t bytes = BlockStore::record_bytes(grid.spec.connectivity);
  std::size_t blocks = 0;
  for (const StoredBlocks& tiles : shards) blocks += tiles.record.size();
  if (blocks != grid.block_count()) {  // before room is made for what is not there
    throw geom::InputError("lattice", {.says = fmt::format("its shards have {} blocks of {}",
                                                           blocks, grid.block_count())});
  }
  JoinedTiles joined;
  joined.record.resize(grid.block_count());
  std::size_t stored = 0;
  for (std::size_t s = 0; s < shards.size(); ++s) {
    const StoredBlocks& tiles = shards[s];
    const std::size_t own = tiles.records.size() / bytes;
    const geom::Shard shard{s, shards.size()};
    std::size_t at = 0;
    std::size_t numbered = 0;
    for (std::size_t t = shard.begin(order.count()); t < shard.end(order.count()); ++t) {
      order.for_each_block(t, [&](std::size_t block, const Index3&) {
        if (at == tiles.record.size()) refuse_shard(s, "has too few blocks");
        const std::uint32_t record = tiles.record[at++];
        const bool has_one = record < BlockStore::kFree;
        if (has_one && record >= own) refuse_shard(s, "numbers a record that is not there");
        joined.record[block] = has_one ? static_cast<std::uint32_t>(stored + record) : record;
        numbered += has_one;
      });
    }
    if (at != tiles.record.size()) refuse_shard(s, "has too many blocks");
    if (numbered != own) refuse_shard(s, "has records that no block has, or several");
    stored += own;
    require_numbers(stored);
    joined.records.push_back(tiles.records);
    add(joined.counts, tiles.counts);
  }
  return joined;
}

std::shared_ptr<const BlockStore> store_joined(const LatticeGrid& grid,
                                               std::span<const StoredBlocks> shards) {
  struct Kept {
    JoinedTiles tiles;
    Bytes records;
    std::shared_ptr<const void> alone;
  };
  const auto kept = std::make_shared<Kept>();
  kept->tiles = join_tiles(grid, shards);
  auto records = kept->tiles.records.front();
  if (shards.size() == 1) {
    kept->alone = shards[0].keep_alive;
  } else {
    for (const auto& more : kept->tiles.records) kept->records.append(more);
    records = kept->records.view();
  }
  const StoredBlocks blocks{kept->tiles.counts, kept->tiles.record, records, kept};
  return std::make_shared<const BlockStore>(grid, blocks, "lattice");
}

std::vector<geom::NamedArray> block_arrays(const LatticeGrid& grid,
                                           std::span<const std::uint32_t> record,
                                           std::vector<std::span<const std::byte>> records) {
  std::size_t bytes = 0;
  for (const auto& some : records) bytes += some.size();
  const std::size_t columns = BlockStore::record_bytes(grid.spec.connectivity);
  return {geom::named_array<std::uint32_t>("block_record", record),
          {"records", "|u1", {bytes / columns, columns}, std::move(records)}};
}

StoredBlocks read_blocks(const geom::ArrayArchive& archive, const LatticeGrid& grid,
                         LatticeCounts counts) {
  const std::size_t columns = BlockStore::record_bytes(grid.spec.connectivity);
  return {counts, archive.array<std::uint32_t>("block_record"),
          std::as_bytes(archive.array<std::uint8_t>("records", columns)), archive.keep_alive()};
}

}  // namespace plan
