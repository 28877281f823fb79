#include "fuzz/reader.h"
#include "geom/zone/read_zones.h"
#include "geom/zone/zone_boxes.h"

namespace {

void zones(std::istream& in) {
  const geom::ZoneFile file = geom::read_zones(fuzz::rest_of(in), "fuzz");
  geom::BoxMapSpec spec;
  spec.bounds = {{-100, -100, 0}, {100, 100, 50}};
  spec.frame.origin = geom::GeodeticOrigin{47, 8, 0};
  spec.epoch = "2026-05-04T00:00:00Z";
  geom::zone_boxes(file, "fuzz", {.spec = spec, .slack = 10, .clock = {spec.epoch, 2}});
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"zones", zones}}; }
