#include <zlib.h>

#include "crc.h"

namespace geom {

std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t crc) {
  if (bytes.empty()) return crc;  // crc32_z() starts anew when it is given no buffer
  return static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t crc32_joined(std::uint32_t before, std::uint32_t after, std::size_t after_size) {
  return static_cast<std::uint32_t>(crc32_combine(before, after, static_cast<z_off_t>(after_size)));
}

}  // namespace geom
