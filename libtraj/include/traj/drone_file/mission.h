#pragma once

// MAVLink missions: what WPL files and QGroundControl plans hold.

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polyline.h"
#include "traj/curve/trajectory.h"
#include "traj/curve/vertical_ends.h"

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
  std::optional<double> speed;  // m/s, the largest asked for; absent where a leg has none
  bool returns = false;         // ends with a return to home, by a way the file does not say
  bool ended = false;           // by a landing, a return or loitering; else it may have been cut
  bool cuts_corners = false;    // a point between two legs without a rest: the vehicle turns early
  // m from home to the take-off's place, where those differ: it climbs at home and goes there. Some
  // autopilots take no heed of a take-off's place and go on from above home.
  double takeoff_from_home = 0;
};

// How far a vehicle may be from the places that a file says, along each axis: latitudes and
// longitudes travel as whole 1e-7 degrees, cut or rounded by the ground station, and heights are
// kept to centimetres by some autopilots.
inline const Vec3 kMissionStray{0.0112, 0.0112, 0.01};

// Whether that is a place on Earth within 10 degrees of latitude and 20 of longitude of the origin.
bool is_near(const geom::GeodeticOrigin& origin, double latitude, double longitude);

// Waypoints, take-offs, landings, loitering for a time (as a rest) and speeds; commands that are
// known to move nothing (cameras, gimbals, servos, yaw) are passed over. `home` is the z of home,
// for files that do not say it. Throws geom::InputError(source, line, …) for all others (splines,
// turns, jumps, changes of height or mode, what is not known), items after the end of the flight, a
// second take-off, loitering on a circle, heights above terrain, places that are not near the
// origin, and a height above home without home.
FlownMission flown_mission(const Mission& mission, const MissionFrame& frame,
                           std::optional<double> home, std::string_view source);

}  // namespace traj
