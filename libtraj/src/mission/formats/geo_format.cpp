#include "geo_format.h"

#include <fmt/format.h>

#include <utility>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"

namespace traj {
namespace {

constexpr double kGeodesy = 1e-8;  // m: what a projection may be off by

// Metres above the ellipsoid of what the heights count from.
double zero_of(LineHeights heights, const MissionFrame& over, const geom::GeodeticPlace& place) {
  if (heights == LineHeights::above_ellipsoid) return 0;
  return over.sea_level(place.latitude, place.longitude);
}

geom::Polyline on_map(const GeoPoints& places, const MissionFrame& over, LineHeights heights,
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
    place.height += zero_of(heights, over, place);
    path.push_back(earth.enu(place));
  }
  return path;
}

}  // namespace

ReadFlights fly_lines(const std::vector<GeoPoints>& lines, LineHeights heights,
                      const ReadTask& task) {
  const MissionFrame over = task.how.placement.mission_frame(task.frame);
  const double error = heights == LineHeights::above_sea ? over.sea_error() : 0;
  ReadFlights out;
  for (const GeoPoints& line : lines) {
    FlownLegs flown{on_map(line, over, heights, task.source)};
    flown.path_stray = Vec3(kGeodesy, kGeodesy, error);
    out.flights.push_back({std::move(flown)});
  }
  return out;
}

WrittenMission write_line(const MissionTask& task, const geom::Polyline& legs, LineHeights heights,
                          void (*write)(std::ostream&, const GeoLine&)) {
  const MissionFrame over = task.options.placement.mission_frame(task.frame);
  require_near_origin(legs, over.origin, task.flight->id);
  const geom::GeographicFrame earth(over.origin);
  GeoLine line{task.flight->id, unchecked_note(task), {}};
  for (const Vec3& p : legs) {
    line.points.push_back(earth.place(p));
    line.points.back().height -= zero_of(heights, over, line.points.back());
  }
  geom::TextOutput text;
  write(text, line);
  WrittenMission written{text.str()};
  written.reading.placement = placement_to_read(task, over);
  return written;
}

}  // namespace traj
