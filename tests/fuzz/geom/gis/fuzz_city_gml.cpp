#include "fuzz/readers.h"
#include "gis/city_gml.h"
#include "import/city_footprints.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const geom::gis::CityGml city = geom::gis::read_city_gml(in, "fuzz", "ridge");
    geom::footprints_of(city.model, 1, {});
  });
}
