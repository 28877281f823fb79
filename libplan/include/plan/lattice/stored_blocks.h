#pragma once

// The masks of a lattice as its files hold them.
//
// No example: a LatticePart holds them, and read_lattice() and write_lattice() use them.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "plan/lattice/lattice.h"

namespace plan {

// Blocks of 8 x 8 x 8 nodes, those of a whole lattice (x fastest) or of a run of its tiles (in the
// order of the tiles). The spans are valid while `keep_alive` lives. See docs/formats.md.
struct StoredBlocks {
  LatticeCounts counts;
  std::span<const std::uint32_t> record;  // of each block: a number, or that it is free or blocked
  std::span<const std::byte> records;
  std::shared_ptr<const void> keep_alive;
};

}  // namespace plan
