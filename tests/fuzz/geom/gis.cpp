#include "fuzz/reader.h"
#include "gis/city_gml.h"
#include "import/city_footprints.h"

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"city_gml", [](std::istream& in) {
             const geom::gis::CityGml city = geom::gis::read_city_gml(in, "fuzz", "ridge");
             geom::footprints_of(city.model, 1, {});
           }}};
}
