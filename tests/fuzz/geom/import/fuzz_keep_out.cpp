#include "fuzz/readers.h"
#include "geom/import/keep_out.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{60, 25, 0}, ""};
    geom::read_keep_out(in, "fuzz", frame, {.epoch = "2026-05-04T06:30:00Z"});
  });
}
