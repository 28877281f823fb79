#include "footprints/city_gml.h"
#include "fuzz/readers.h"
#include "geom/import/city_footprints.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const footprints::CityGml city = footprints::read_city_gml(in, "fuzz", "ridge");
    geom::footprints_of(city.model, 1, {});
  });
}
