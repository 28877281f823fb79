#include "fuzz/readers.h"
#include "geom/import/fcnd_csv.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) { geom::read_fcnd_csv(in, "fuzz"); });
}
