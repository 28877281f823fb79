#pragma once

// Reads the directory of ZIP archives, where they stand in memory.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace geom {

struct ZipEntry {
  std::string name;
  std::uint64_t header = 0;          // where its local header starts, bytes into the archive
  std::span<const std::byte> bytes;  // what it stores: a part of the archive
  std::uint32_t crc = 0;             // of its content, as the directory says; not checked
  std::uint64_t size = 0;            // of its content, as the directory says
  bool deflated = false;             // else `bytes` are its content
  bool described = false;            // what follows the bytes is a data descriptor
};

// What an archive may be.
struct ZipRules {
  const char* what = "a map, lattice, roadmap or shard of Skyway";
  std::uint64_t most_entries = 65536;  // ours have a dozen
  bool foreign = false;  // made elsewhere: entries may be deflated, and nothing stands between them
};

// The entries of `archive` in the order of their places, Zip64 or not. `name` is the archive's, for
// messages. InputError where the directory and the headers do not fit the bytes that are there, or
// each other, for compression (unless `foreign`), encryption, and for names that come twice and
// entries that overlap.
std::vector<ZipEntry> read_zip(std::span<const std::byte> archive, const std::string& name,
                               const ZipRules& rules = {});

}  // namespace geom
