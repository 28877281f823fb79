#pragma once

// What the formats of lines on Earth share.

#include <iosfwd>
#include <vector>

#include "traj/mission/formats/geo_line.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// What heights of a format count from.
enum class LineHeights { above_sea, above_ellipsoid };

// The lines over the map. Throws geom::InputError for heights where the map's is not known, and for
// places that are not near the origin.
ReadFlights fly_lines(const std::vector<GeoPoints>& lines, LineHeights heights,
                      const ReadTask& task);

WrittenMission write_line(const MissionTask& task, const geom::Polyline& legs, LineHeights heights,
                          void (*write)(std::ostream& out, const GeoLine& line));

}  // namespace traj
