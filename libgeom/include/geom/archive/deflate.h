#pragma once

// Compression of bytes that a web page or an archive holds.
//
// Example:
//   const std::string zeros(1000, '\0');
//   assert(geom::deflated(std::as_bytes(std::span(zeros))).size() < 50);

#include <cstddef>
#include <span>
#include <string>

namespace geom {

// The bytes as raw deflate data (RFC 1951), without a header or checksum. Fewer than 2^32 bytes
// (precondition). The same bytes give the same data with one version of zlib.
std::string deflated(std::span<const std::byte> bytes);

}  // namespace geom
