#pragma once

// Marks and sizes of the ZIP records, from PKWARE's APPNOTE 6.3.

#include <cstddef>
#include <cstdint>

namespace geom {

constexpr std::uint32_t kLocalMark = 0x04034b50;
constexpr std::uint32_t kCentralMark = 0x02014b50;
constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::uint32_t kEnd64Mark = 0x06064b50;
constexpr std::uint32_t kLocatorMark = 0x07064b50;
constexpr std::uint16_t kZip64Extra = 1;

// A field that stands so is too small for its value, which a Zip64 field holds instead.
constexpr std::uint32_t kFull32 = 0xffffffff;
constexpr std::uint16_t kFull16 = 0xffff;

// Bytes of each record without what varies (names, extra fields, comments).
constexpr std::size_t kLocalSize = 30;
constexpr std::size_t kCentralSize = 46;
constexpr std::size_t kEndSize = 22;
constexpr std::size_t kLocatorSize = 20;
constexpr std::size_t kEnd64Size = 56;

// Data start at multiples of this in the file, and so in memory when it is mapped.
constexpr std::size_t kAlignment = 64;

}  // namespace geom
