#include "fuzz/reader.h"
#include "traj/home/contingency_record.h"
#include "traj/home/landing_site.h"
#include "traj/home/rally_file.h"

namespace {

void rally(std::istream& in) {
  const geom::Frame frame{geom::Axes::neu, geom::GeodeticOrigin{47.4, 8.5, 400}, ""};
  for (const geom::Vec3& place : traj::read_rally(in, "fuzz", frame)) {
    if (!place.allFinite()) __builtin_trap();
  }
}

// Of places in the map, and in degrees.
void sites(std::istream& in) {
  const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{60, 25, 0}, ""};
  const std::string bytes = fuzz::rest_of(in);
  fuzz::takes(bytes,
              [&](std::istream& it) { traj::read_sites(it, "fuzz", frame, {.local = true}); });
  fuzz::takes(bytes, [&](std::istream& it) { traj::read_sites(it, "fuzz", frame, {}); });
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"contingency",
           [](std::istream& in) { traj::parse_contingency_record(fuzz::rest_of(in), "fuzz", 1); }},
          {"rally", rally},
          {"sites", sites}};
}
