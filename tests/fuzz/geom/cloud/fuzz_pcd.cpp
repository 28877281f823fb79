#include "fuzz/readers.h"
#include "geom/cloud/point_cloud.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    geom::read_pcd(in, "fuzz", [](std::span<const geom::CloudPoint>) {});
  });
}
