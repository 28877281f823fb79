#pragma once

// A drone file as what it makes a vehicle fly over a map.
//
// Example, not run:
//   std::ifstream in("mission.plan");
//   const std::string text(std::istreambuf_iterator<char>(in), {});
//   traj::MissionReading reading;
//   reading.placement.origin = geom::GeodeticOrigin{47.4, 8.5, 400};
//   reading.rules.return_height = 30;
//   const traj::MissionFormat& format = traj::recognised_mission_format(text);
//   const auto flights =
//       traj::read_mission(text, "mission.plan", format, reading, map.spec().frame);

#include <string>
#include <vector>

#include "traj/mission/formats/mission_formats.h"

namespace traj {

// One flight of a file.
struct FileFlight {
  std::string id;
  const MissionFormat* format = nullptr;
  Flown flown;                     // in the map's axes
  std::vector<std::string> notes;  // what its user should know before flying it, for warnings
  // The profile of data/vehicles that holds the aircraft which the file is for; empty: not known.
  std::string_view vehicle = {};
};

// All that is in a file of this text: one flight, or of lines (KML, GeoJSON, glTF) and tables of
// paths several, at least one. The id is the source's name without folder and extension, with -1,
// -2, … where there are several, or the table's. Throws geom::InputError for bad text and for what
// cannot be flown or is not known, geom::UsageError where `reading` lacks what the format needs.
// The format must be one that is read.
std::vector<FileFlight> read_mission(const std::string& text, const std::string& source,
                                     const MissionFormat& format, const MissionReading& reading,
                                     const geom::Frame& frame);

}  // namespace traj
