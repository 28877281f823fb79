#include <algorithm>

#include "fuzz/readers.h"
#include "geom/cloud/copc.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [&](std::istream&) {
    const geom::ReadAt read = [&](std::uint64_t at, std::span<unsigned char> to) {
      const std::size_t n = at < size ? std::min<std::size_t>(to.size(), size - at) : 0;
      std::copy_n(data + (n > 0 ? at : 0), n, to.data());
      return n;
    };
    const geom::CopcPart part{geom::Aabb{{100, 100, 0}, {700, 700, 0}}, 3};
    geom::read_copc(
        read, "fuzz", [&](const geom::CoordinateReference&) { return part; },
        [](std::span<const geom::CloudPoint>) {});
  });
}
