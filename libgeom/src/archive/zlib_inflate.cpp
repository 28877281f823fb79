#include <zlib.h>

#include <limits>

#include "inflate.h"

namespace geom {

std::optional<std::string> inflated(std::span<const std::byte> data, std::size_t size) {
  // A match of 258 bytes takes 2 bits at least (zlib's technical notes: 1032 to 1).
  constexpr std::size_t kLargestRatio = 1032;
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  if (data.size() >= kMost || size >= kMost || size / kLargestRatio > data.size()) return {};
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  std::string content(size + 1, '\0');  // a byte more, to see what is too long
  // zlib's interface is not const-correct: it only reads the input.
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(data.data()));
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(content.data());
  stream.avail_out = static_cast<uInt>(content.size());
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.avail_in == 0 && stream.total_out == size;
  inflateEnd(&stream);
  if (!whole) return {};
  content.resize(size);
  return content;
}

}  // namespace geom
