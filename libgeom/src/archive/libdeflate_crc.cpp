#include <libdeflate.h>

#include "crc.h"

namespace geom {

// By libdeflate, which is three times as fast as zlib.
std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t crc) {
  if (bytes.empty()) return crc;  // it starts anew when it is given no buffer
  return libdeflate_crc32(crc, bytes.data(), bytes.size());
}

}  // namespace geom
