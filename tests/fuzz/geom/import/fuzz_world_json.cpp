#include "fuzz/readers.h"
#include "import/world_json.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) { geom::read_world_json(in, "fuzz"); });
}
