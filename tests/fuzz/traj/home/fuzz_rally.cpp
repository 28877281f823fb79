#include "fuzz/readers.h"
#include "traj/home/rally_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const geom::Frame frame{geom::Axes::neu, geom::GeodeticOrigin{47.4, 8.5, 400}, ""};
    for (const geom::Vec3& place : traj::read_rally(in, "fuzz", frame)) {
      if (!place.allFinite()) __builtin_trap();
    }
  });
}
