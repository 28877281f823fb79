#pragma once

// Writes ZIP archives without compression, on streams that cannot seek.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "zip_format.h"

namespace geom {

// Entries in the order they are added, what each one stores from a multiple of `alignment` bytes
// on; Zip64 where a size or place needs it. The clock stands at 1980-01-01. Keeps the directory
// alone in memory.
class ZipWriter {
 public:
  // `out` must outlive it.
  explicit ZipWriter(std::ostream& out, std::size_t alignment = kAlignment)
      : out_(out), alignment_(alignment) {}

  // Stores `head` and the pieces of the body, one after the other.
  void add(const std::string& name, std::string_view head,
           std::span<const std::span<const std::byte>> body);
  void finish();  // writes the directory; nothing may be added after it

 private:
  void write(std::string_view text);
  void add_to_directory(const std::string& name, std::uint32_t crc, std::uint64_t size,
                        std::uint64_t offset);
  void write_end64(std::uint64_t start, std::uint64_t size);

  std::ostream& out_;
  std::size_t alignment_;
  std::string directory_;
  std::uint64_t written_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace geom
