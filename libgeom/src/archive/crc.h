#pragma once

// The checksum of ZIP and PNG.

#include <cstddef>
#include <cstdint>
#include <span>

namespace geom {

// CRC-32 (ISO 3309) of `bytes`, carried on from `crc` of what came before them.
std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t crc = 0);

// CRC-32 of bytes and what follows them, from those of both.
std::uint32_t crc32_joined(std::uint32_t before, std::uint32_t after, std::size_t after_size);

}  // namespace geom
