#pragma once

// The compression of ZIP entries.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace geom {

// What raw deflate data (RFC 1951) hold: `size` bytes, no more and no fewer, the data used to their
// end. Nothing otherwise, and where the data are damaged. Memory: `size`, or what the data can hold
// at most where that is less.
std::optional<std::string> inflated(std::span<const std::byte> data, std::size_t size);

}  // namespace geom
