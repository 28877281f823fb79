#include "fuzz/readers.h"
#include "geom/model/model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) { geom::read_ply_model(in, "fuzz"); });
}
