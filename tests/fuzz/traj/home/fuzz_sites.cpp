#include "fuzz/readers.h"
#include "traj/home/landing_site.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{60, 25, 0}, ""};
  refuses_or_reads(data, size,
                   [&](std::istream& in) { traj::read_sites(in, "fuzz", frame, {.local = true}); });
  return refuses_or_reads(data, size,
                          [&](std::istream& in) { traj::read_sites(in, "fuzz", frame, {}); });
}
