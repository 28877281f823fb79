#include "fuzz/reader.h"
#include "geom/import/volume_keep_out.h"
#include "geom/record/path_csv.h"
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

void plan_queries(std::istream& in) {
  static const geom::BoxMap map = somewhere();
  static const geom::Locator locator(map);
  geom::read_plan_queries(in, "fuzz", &locator);
}

void volume4d(std::istream& in) {
  const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{48, 16, 200}, ""};
  const auto volumes = geom::read_volumes_4d(in, "fuzz");
  geom::keep_out_of(volumes, "fuzz", frame, {{}, 0, 100});
  std::istringstream again(geom::operational_intent_details(volumes, 0));
  if (geom::read_volumes_4d(again, "again").size() != volumes.size()) __builtin_trap();
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"path_csv", [](std::istream& in) { geom::read_path_csv(in, "fuzz"); }},
          {"plan_queries", plan_queries},
          {"volume4d", volume4d}};
}
