#pragma once

// The checksum of ZIP and PNG.

#include <cstddef>
#include <cstdint>
#include <span>

namespace geom {

// CRC-32 (ISO 3309) of `bytes`, carried on from `crc` of what came before them.
std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t crc = 0);

}  // namespace geom
