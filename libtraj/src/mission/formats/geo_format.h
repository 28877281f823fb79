#pragma once

// What the formats of lines on Earth share.

#include <iosfwd>
#include <vector>

#include "traj/mission/formats/geo_line.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// The lines over the map; `geoid` metres are added to their heights. Throws geom::InputError for
// heights where the map's is not known, and for places that are not near the origin.
ReadFlights fly_lines(const std::vector<GeoPoints>& lines, const MissionFrame& over, double geoid,
                      const ReadTask& task);

// `below`: metres that are taken from the heights.
WrittenMission write_line(const MissionTask& task, const geom::Polyline& legs,
                          const MissionFrame& over, double below,
                          void (*write)(std::ostream& out, const GeoLine& line));

}  // namespace traj
