#include "fuzz/readers.h"
#include "traj/mission/formats/geo_line.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) { traj::read_kml(in, "fuzz"); });
}
