#include "fuzz/readers.h"
#include "import/jps3d_map.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size,
                          [](std::istream& in) { geom::read_jps3d_map(in, "fuzz", {true}); });
}
