#include <zlib.h>

#include "crc.h"

namespace geom {

std::uint32_t crc32_joined(std::uint32_t before, std::uint32_t after, std::size_t after_size) {
  return static_cast<std::uint32_t>(crc32_combine(before, after, static_cast<z_off_t>(after_size)));
}

}  // namespace geom
