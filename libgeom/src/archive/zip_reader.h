#pragma once

// Reads the directory of ZIP archives without compression, where they stand in memory.

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
  std::uint32_t crc = 0;             // of these bytes, as the directory says; not checked
};

// The entries of `archive` in the order of their places, Zip64 or not. `name` is the archive's, for
// messages. InputError where the directory and the headers do not fit the bytes that are there, for
// compression, encryption, and for names that come twice and entries that overlap.
std::vector<ZipEntry> read_zip(std::span<const std::byte> archive, const std::string& name);

}  // namespace geom
