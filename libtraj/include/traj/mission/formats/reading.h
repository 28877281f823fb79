#pragma once

// What reading a drone file takes beside its text, and what comes out.
//
// Example:
//   traj::MissionReading reading;
//   reading.placement.origin = geom::GeodeticOrigin{47.4, 8.5, 400};
//   reading.flier.autopilots = {traj::px4("1.17")};

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/formats/flier.h"
#include "traj/mission/formats/placement.h"

namespace traj {

struct MissionReading {
  Placement placement = {};
  std::optional<Vec3> start = {};  // where a Tello stands, in the map's axes
  MissionRules rules = {};         // but for home, which is the placement's ground
  Flier flier = {};
};

// What the reader of a format gets.
struct ReadTask {
  std::string source;  // for messages
  const MissionReading& how;
  geom::Frame frame;  // of the map
};

// What it gives: all flights of the text, in ENU, and what their user should know.
struct ReadFlights {
  std::vector<Flown> flights;
  std::vector<std::string> notes = {};
  std::vector<std::string> ids = {};  // one a flight; empty: the text has none
  // The profile of data/vehicles that holds the aircraft which the text is for; empty: not known.
  std::string_view vehicle = {};
};

}  // namespace traj
