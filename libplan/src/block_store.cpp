#include "block_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "geom/error.h"
#include "geom/parallel.h"

namespace plan {
namespace {

constexpr std::int64_t kSide = LatticeGrid::kSide;
constexpr std::size_t kBlock = LatticeGrid::kBlock;
constexpr std::int64_t kTile = 4;  // columns of blocks along the edge of what one thread does
constexpr std::uint32_t kFreeBit16 = 1u << kHalfDirections;

// One block's masks without a record, or as one.
std::uint32_t classify(const LatticeGrid& grid, const Index3& low, const Lattice::Block& masks) {
  bool any = false;
  bool all = true;
  std::size_t n = 0;
  for (std::int64_t k = 0; k < kSide; ++k) {
    for (std::int64_t j = 0; j < kSide; ++j) {
      for (std::int64_t i = 0; i < kSide; ++i, ++n) {
        const Index3 node = {low[0] + i, low[1] + j, low[2] + k};
        any = any || masks[n] != 0;
        all = all && (!grid.contains(node) ||
                      masks[n] == (Lattice::kNode | grid.possible(node)));
      }
    }
  }
  return all ? BlockStore::kFree : any ? 0 : BlockStore::kBlocked;
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

struct Tile {
  std::vector<std::pair<std::size_t, std::uint32_t>> blocks;  // and their records in this tile
  std::vector<std::byte> records;
  LatticeCounts counts;
};

Tile read_tile(const LatticeGrid& grid, const MaskSource& source, std::int64_t x, std::int64_t y) {
  const Index3 n = grid.blocks();
  Tile tile;
  Lattice::Block masks;
  std::uint32_t records = 0;
  for (std::int64_t k = 0; k < n[2]; ++k) {
    for (std::int64_t j = y; j < std::min(y + kTile, n[1]); ++j) {
      for (std::int64_t i = x; i < std::min(x + kTile, n[0]); ++i) {
        const Index3 low = {i * kSide, j * kSide, k * kSide};
        source.read(low, {kSide, kSide, kSide}, masks.data());
        std::uint32_t record = classify(grid, low, masks);
        if (record == 0) {
          record = records++;
          append_record(grid.spec.connectivity, masks, tile.records);
        }
        for (const std::uint32_t mask : masks) {
          tile.counts.nodes += mask >> 31;
          tile.counts.edges += static_cast<std::size_t>(std::popcount(mask & (kFreeBit16 - 1)));
        }
        tile.blocks.emplace_back(static_cast<std::size_t>(i + n[0] * (j + n[1] * k)), record);
      }
    }
  }
  return tile;
}

struct Owned {
  std::vector<std::uint32_t> record;
  std::vector<std::byte> records;
};

}  // namespace

BlockStore::BlockStore(const LatticeGrid& grid, LatticeCounts counts,
                       std::span<const std::uint32_t> record, std::span<const std::byte> records,
                       std::shared_ptr<const void> keep_alive, std::string name)
    : grid_(grid),
      counts_(counts),
      record_(record),
      records_(records),
      keep_alive_(std::move(keep_alive)),
      name_(std::move(name)) {
  if (record_.size() != grid_.block_count()) {
    refuse(fmt::format("expected {} blocks, found {}", grid_.block_count(), record_.size()));
  }
  const std::size_t count = records_.size() / record_bytes(grid_.spec.connectivity);
  std::size_t stored = 0;
  for (std::size_t b = 0; b < record_.size(); ++b) {
    if (record_[b] >= kFree) continue;
    ++stored;
    if (record_[b] >= count) {
      refuse(fmt::format("block {} has record {} of {}", b, record_[b], count));
    }
  }
  if (stored != count) {
    refuse(fmt::format("expected a record for each of {} blocks, found {}", stored, count));
  }
}

void BlockStore::refuse(const std::string& message) const {
  throw geom::InputError(name_, message);
}

std::uint32_t BlockStore::stored(std::uint32_t record, std::size_t local) const {
  const std::byte* const at = records_.data() + record * record_bytes(grid_.spec.connectivity);
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
        const auto block = static_cast<std::size_t>(i / kSide + n[0] * (j / kSide + n[1] * (k / kSide)));
        const std::uint32_t record = record_[block];
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
          refuse(fmt::format("node {} of block {} has an edge that cannot be", local, block));
        }
        *out = mask;
      }
    }
  }
}

void BlockStore::check() const {
  for (std::size_t b = 0; b < record_.size(); ++b) {
    if (record_[b] >= kFree) continue;
    const Index3 low = grid_.block_low(b);
    for (std::size_t n = 0; n < kBlock; ++n) {
      const auto local = static_cast<std::int64_t>(n);
      const Index3 node = {low[0] + local % kSide, low[1] + local / kSide % kSide,
                           low[2] + local / (kSide * kSide)};
      if (!grid_.contains(node) && stored(record_[b], n)) {
        refuse(fmt::format("place {} of block {} is outside the lattice, but not 0", n, b));
      }
    }
  }
}

std::shared_ptr<const BlockStore> store_blocks(const LatticeGrid& grid, const MaskSource& source,
                                               const geom::Execution& run) {
  const Index3 n = grid.blocks();
  const std::int64_t across = (n[0] + kTile - 1) / kTile;
  const std::int64_t along = (n[1] + kTile - 1) / kTile;
  std::vector<Tile> tiles(static_cast<std::size_t>(across * along));
  geom::parallel_for(tiles.size(), run, [&](std::size_t t) {
    const auto tile = static_cast<std::int64_t>(t);
    tiles[t] = read_tile(grid, source, tile % across * kTile, tile / across * kTile);
  });
  auto owned = std::make_shared<Owned>();
  owned->record.resize(grid.block_count());
  std::size_t bytes = 0;
  for (const Tile& tile : tiles) bytes += tile.records.size();
  owned->records.reserve(bytes);
  LatticeCounts counts;
  for (Tile& tile : tiles) {
    const auto first = static_cast<std::uint32_t>(
        owned->records.size() / BlockStore::record_bytes(grid.spec.connectivity));
    for (const auto& [block, record] : tile.blocks) {
      owned->record[block] = record >= BlockStore::kFree ? record : first + record;
    }
    owned->records.insert(owned->records.end(), tile.records.begin(), tile.records.end());
    counts.nodes += tile.counts.nodes;
    counts.edges += tile.counts.edges;
    tile = {};  // so that no more than one copy is ever held
  }
  return std::make_shared<const BlockStore>(grid, counts, owned->record, owned->records, owned,
                                            "lattice");
}

}  // namespace plan
