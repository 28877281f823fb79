#include "fuzz/readers.h"
#include "geom/record/query_record.h"

namespace {

// A map that knows where it is on Earth, so that places in degrees are read, too.
geom::BoxMap somewhere() {
  geom::BoxMapSpec spec;
  spec.bounds = {{-1000, -1000, 0}, {1000, 1000, 100}};
  spec.frame.origin = geom::GeodeticOrigin{60.17, 24.94, 0};
  geom::BoxTable boxes;
  boxes.add({{-10, -10, 0}, {10, 10, 15}}, 1);
  return geom::BoxMap(spec, boxes);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const geom::BoxMap map = somewhere();
  static const geom::Locator locator(map);
  return refuses_or_reads(data, size,
                          [](std::istream& in) { geom::read_plan_queries(in, "fuzz", &locator); });
}
