#include "fuzz/readers.h"
#include "import/city_footprints.h"
#include "import/city_json.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    geom::footprints_of(geom::read_city_json(in, "fuzz"), 1, {});
  });
}
