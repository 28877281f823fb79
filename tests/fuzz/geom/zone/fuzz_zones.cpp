#include <iterator>
#include <string>

#include "fuzz/readers.h"
#include "geom/zone/read_zones.h"
#include "geom/zone/zone_boxes.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const geom::ZoneFile file = geom::read_zones(text, "fuzz");
    geom::BoxMapSpec spec;
    spec.bounds = {{-100, -100, 0}, {100, 100, 50}};
    spec.frame.origin = geom::GeodeticOrigin{47, 8, 0};
    spec.epoch = "2026-05-04T00:00:00Z";
    geom::zone_boxes(file, "fuzz", {.spec = spec, .slack = 10, .clock = {spec.epoch, 2}});
  });
}
