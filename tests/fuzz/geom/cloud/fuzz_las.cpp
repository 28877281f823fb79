#include <algorithm>
#include <cstdlib>

#include "fuzz/readers.h"
#include "geom/cloud/point_cloud.h"

// With a second way into the file, the same bytes are read or refused; the points are counted.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto points = [&](const geom::LasReading& reading) {
    std::size_t count = 0;
    bool read = false;
    refuses_or_reads(data, size, [&](std::istream& in) {
      const auto sink = [&](std::span<const geom::CloudPoint> chunk) { count += chunk.size(); };
      geom::read_las(in, "fuzz", sink, {}, reading);
      read = true;
    });
    return std::pair(read, read ? count : 0);
  };
  const geom::ReadAt ahead = [&](std::uint64_t at, std::span<unsigned char> to) {
    const std::size_t n = at < size ? std::min<std::size_t>(to.size(), size - at) : 0;
    std::copy_n(data + (n > 0 ? at : 0), n, to.data());
    return n;
  };
  if (points({}) != points({{2, {}}, ahead})) std::abort();
  return 0;
}
