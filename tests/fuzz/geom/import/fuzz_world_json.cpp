#include "fuzz/readers.h"
#include "geom/import/import_boxes.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(
      data, size, [](std::istream& in) { geom::import_boxes(in, geom::kRotorPyWorld, "fuzz"); });
}
