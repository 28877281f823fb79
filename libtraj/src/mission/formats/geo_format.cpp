#include "geo_format.h"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "geom/base/error.h"

namespace traj {
namespace {

constexpr double kGeodesy = 1e-8;  // m: what a projection may be off by

geom::Polyline on_map(const GeoPoints& places, const MissionFrame& over, double geoid,
                      std::string_view source) {
  if (!over.height_known) {
    throw geom::InputError(source, {.says = "its heights are above the sea or the ellipsoid, and "
                                            "the map does not say how high its z = 0 is",
                                    .advice = "give --origin latitude,longitude,height"});
  }
  const geom::GeographicFrame earth(over.origin);
  geom::Polyline path;
  for (geom::GeodeticPlace place : places) {
    if (!is_near(over.origin, place.latitude, place.longitude)) {
      throw geom::InputError(
          source,
          {.expected = fmt::format("a place near the origin, latitude {} longitude {}",
                                   over.origin.latitude, over.origin.longitude),
           .found = fmt::format("latitude {} longitude {}", place.latitude, place.longitude)});
    }
    place.height += geoid;
    path.push_back(earth.enu(place));
  }
  return path;
}

}  // namespace

ReadFlights fly_lines(const std::vector<GeoPoints>& lines, const MissionFrame& over, double geoid,
                      const ReadTask& task) {
  ReadFlights out;
  for (const GeoPoints& line : lines) {
    FlownLegs flown{on_map(line, over, geoid, task.source)};
    flown.path_stray = Vec3(kGeodesy, kGeodesy, 0);
    out.flights.push_back({std::move(flown)});
  }
  return out;
}

WrittenMission write_line(const MissionTask& task, const geom::Polyline& legs,
                          const MissionFrame& over, double below,
                          void (*write)(std::ostream&, const GeoLine&)) {
  require_near_origin(legs, over.origin, task.flight->id);
  const geom::GeographicFrame earth(over.origin);
  GeoLine line{task.flight->id, unchecked_note(task), {}};
  for (const Vec3& p : legs) {
    line.points.push_back(earth.place(p));
    line.points.back().height -= below;
  }
  std::ostringstream text;
  write(text, line);
  WrittenMission written{text.str()};
  written.reading.placement = placement_to_read(task, over);
  return written;
}

}  // namespace traj
