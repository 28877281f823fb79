#pragma once

// Masks of a lattice in blocks of 8 x 8 x 8 nodes; those that are all free or all blocked take no
// room.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geom/archive/array_archive.h"
#include "geom/base/error.h"
#include "geom/base/execution.h"
#include "geom/base/shard.h"
#include "plan/lattice/lattice.h"
#include "plan/lattice/lattice_part.h"
#include "plan/lattice/stored_blocks.h"

namespace plan {

class BlockStore final : public MaskSource {
 public:
  static constexpr std::uint32_t kBlocked = 0xffffffff;  // in place of a record's number
  static constexpr std::uint32_t kFree = 0xfffffffe;

  // Bytes of the record of a block: 4 bits a node (6 neighbours) or 16, x fastest, little endian.
  // The lower bits are the half directions, the next one (bit 3 or 13) is that the node is free.
  static std::size_t record_bytes(Connectivity connectivity) {
    return connectivity == Connectivity::six ? LatticeGrid::kBlock / 2 : LatticeGrid::kBlock * 2;
  }

  // `blocks` are those of the whole lattice. Throws InputError(name, …) where numbers of records
  // are not each below their count, or not as many as there are.
  BlockStore(const LatticeGrid& grid, StoredBlocks blocks, std::string name);

  // Throws InputError where a record has a bit that cannot be.
  void read(const Index3& low, const Index3& count, std::uint32_t* masks) const override;

  std::string_view name() const override { return name_; }

  void check() const;  // what read() does not see: bits beyond the lattice

  const StoredBlocks& blocks() const { return blocks_; }

 private:
  std::uint32_t stored(std::uint32_t record, std::size_t local) const;
  [[noreturn]] void refuse(geom::Fault fault) const;

  LatticeGrid grid_;
  StoredBlocks blocks_;
  std::string name_;
};

// Of the shard's tiles, which are columns of 4 x 4 blocks, numbered x fastest: for each of their
// blocks, tile after tile and in a tile x fastest, the number of its record among the records, or
// kFree or kBlocked. Records are numbered in that order. Masks are read block by block.
StoredBlocks store_tiles(const LatticeGrid& grid, const MaskSource& source,
                         const geom::Execution& run, const geom::Shard& shard);

// Of each part, which are of one lattice or InputError("lattice", …) is thrown.
std::vector<StoredBlocks> tiles_of(std::span<const LatticePart> parts);

// All tiles, of all shards in their order. The records of a shard follow those of the shards before
// it, and are not copied.
struct JoinedTiles {
  LatticeCounts counts;
  std::vector<std::uint32_t> record;                // of each block
  std::vector<std::span<const std::byte>> records;  // of each shard
};

// Throws InputError("lattice", …) where they don't fit.
JoinedTiles join_tiles(const LatticeGrid& grid, std::span<const StoredBlocks> shards);

// One alone is not copied.
std::shared_ptr<const BlockStore> store_joined(const LatticeGrid& grid,
                                               std::span<const StoredBlocks> shards);

// As arrays of an archive, and back. `records` are those of one store or of shards in their order.
std::vector<geom::NamedArray> block_arrays(const LatticeGrid& grid,
                                           std::span<const std::uint32_t> record,
                                           std::vector<std::span<const std::byte>> records);
StoredBlocks read_blocks(const geom::ArrayArchive& archive, const LatticeGrid& grid,
                         LatticeCounts counts);

}  // namespace plan
