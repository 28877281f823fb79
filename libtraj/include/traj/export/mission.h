#pragma once

// MAVLink missions: what WPL files and QGroundControl plans hold.

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/geographic_frame.h"
#include "geom/polyline.h"
#include "traj/trajectory.h"
#include "traj/vertical_ends.h"

namespace traj {

// MAV_FRAME: heights above sea level, above home.
enum MavFrame {
  kGlobal = 0,
  kMissionFrame = 2,
  kGlobalRelative = 3,
  kGlobalInt = 5,
  kGlobalRelativeInt = 6
};
// MAV_CMD
enum MavCommand {
  kWaypoint = 16,
  kLoiterForever = 17,
  kLoiterTime = 19,
  kReturn = 20,
  kLand = 21,
  kTakeoff = 22,
  kDelay = 93,
  kLastNavigation = 95,
  kJump = 177,
  kSpeed = 178
};

// An item as it stands in a file. NaN: the file says null.
struct MissionItem {
  int frame = kGlobalRelative;
  int command = kWaypoint;
  std::array<double, 4> param{};
  double latitude = 0;   // degrees
  double longitude = 0;  // degrees
  double altitude = 0;   // m
  std::size_t line = 0;  // where it was read; 0: it is counted instead
};

struct Mission {
  std::optional<geom::GeodeticPlace> home;  // height above sea level
  std::vector<MissionItem> items;
};

// How missions are laid over a map.
struct MissionFrame {
  geom::GeodeticOrigin origin;  // of the map, on the ellipsoid
  double geoid = 0;             // m: sea level above the ellipsoid there
};

struct MissionOptions {
  double home = 0;                   // z of the ground under the first point, m
  std::optional<double> landing_on;  // z of the ground under the last; absent: it hovers there
  std::optional<double> speed;       // m/s along the legs; absent: as the vehicle is set
  double hold = 1;                   // s to rest at each waypoint, so that no corner is cut
  double acceptance = 0.2;           // m from a waypoint that count as there
};

// A take-off straight up to the first point, the others as waypoints, relative to home, a landing:
// as the file will hold them, latitudes and longitudes rounded to 1e-7 degrees (as MAVLink sends
// them), heights to millimetres. At least one point, in ENU.
Mission make_mission(std::span<const Vec3> points, const MissionFrame& frame,
                     const MissionOptions& options);

// What a vehicle makes of a mission: straight legs in ENU, a rest at each point.
struct FlownMission {
  geom::Polyline path;
  std::vector<double> hold;  // s, one a point
  VerticalEnds ends;
  std::optional<double> speed;  // m/s, the largest asked for
  bool returns = false;         // ends with a return to home, by a way the file does not say
};

// Waypoints, take-offs, landings, loitering for a time (as a rest) and speeds; commands that move
// nothing are passed over. `home` is the z of home, for files that do not say it. Throws
// geom::InputError(source, line, …) for others that move the vehicle (splines, turns, jumps),
// heights above terrain, places that are not on Earth or over 1000 km from the origin, and a height
// above home without home.
FlownMission flown_mission(const Mission& mission, const MissionFrame& frame,
                           std::optional<double> home, std::string_view source);

}  // namespace traj
