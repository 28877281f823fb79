#include "fuzz/readers.h"
#include "geom/import/volume_keep_out.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{48, 16, 200}, ""};
    const auto volumes = geom::read_volumes_4d(in, "fuzz");
    geom::keep_out_of(volumes, "fuzz", frame, {{}, 0, 100});
    std::istringstream again(geom::operational_intent_details(volumes, 0));
    if (geom::read_volumes_4d(again, "again").size() != volumes.size()) __builtin_trap();
  });
}
