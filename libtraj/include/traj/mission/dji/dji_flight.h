#pragma once

// The flight of an aircraft of DJI on a mission: its legs, and the regions that it may fly through.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   const traj::DjiMission mission = traj::make_dji_mission(points, frame, {.speed = 6});
//   const traj::FlownDji flown = traj::flown_dji(mission, frame, {.ground = 0}, "mission.kmz");
//   assert(flown.path.size() >= points.size());

#include <optional>
#include <string_view>

#include "geom/map/geographic_frame.h"
#include "traj/curve/mission_frame.h"
#include "traj/mission/dji/dji_mission.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/flown/terrain_rules.h"

namespace traj {

// What an aircraft makes of a mission: straight legs in ENU, and the regions that it may fly
// through anywhere where it does not stop. Items are waypoints, counted from 0 over all waylines.
struct FlownDji : FlownMission {
  std::optional<double> returns_at;  // m above home, where the path ends with a return
  geom::GeodeticPlace home_place;    // home's; height on the ellipsoid
  bool home_is_said = false;         // its place is the file's; else it is below the first waypoint
};

// What a file leaves open, as far as its user says it.
struct DjiRules {
  std::optional<double> ground;         // z of the ground at the take-off, m
  std::optional<double> return_height;  // m above the take-off, where the file does not say it
  // Between which heights the aircraft stays where it follows the surface (rules->surface), and
  // metres along each axis that it may be off its way there.
  std::optional<TerrainRules> surface = {};
  double around = 0;
};

// The model, after DJI's documentation of WPML (cloud-api: waylines.wpml, common element):
// - The take-off is at the file's takeOffRefPoint, else below the first waypoint; `ground` goes
//   before that point's height. Heights relative to the start count from there.
// - It rises straight up to takeOffSecurityHeight, or "safely" to the first waypoint's height where
//   that is more. "Safely" it then flies level to above the waypoint and sinks onto it; from point
//   to point it flies straight there, or level first where that waypoint is lower.
// - From one wayline to the next, "safely", it rises to the height of the next waypoint where that
//   is more, flies level, and sinks; else straight.
// - Legs are straight, with a stop at each waypoint. A coordinated turn stays in the triangle
//   between the waypoint and the places at waypointTurnDampingDist before and behind it; one that
//   passes through the waypoint, which may swing wide, within that distance of it in plan and
//   within the difference of these places' heights beyond them. No two turns of a leg may meet.
// - An aircraft whose airframe is known climbs and sinks no faster than that does, whatever speed
//   the file asks for.
// - goHome rises to globalRTHHeight (else `return_height`) where it is lower, flies level to above
//   home, and lands. Within 50 m of home some aircraft do not rise: all heights between are swept.
// - realTimeFollowSurface: DJI states no bound for this. The aircraft is where `surface` says,
//   whatever executeHeight is. It rises to takeOffSecurityHeight, goes above the first waypoint and
//   into the band of heights; on the way it may be anywhere in the upright face between. Each leg
//   is in pieces of at most 5 m, each with the heights over the ground below it. From one wayline
//   to the next it may be at any height that it may have on the way. A return begins anywhere in
//   the band, and is flown at any of the heights to which it rises. The take-off must be on that
//   ground within 5 m, or they count from different zeros.
// A return from within 20 m of home, where some land at once, or without a height is no way that is
// known (`returns`). Nor is gotoFirstWaypoint.
// Throws geom::InputError(source, …) where the file says another height of the return than
// `return_height`; with a line, where waylines follow the surface and `surface` is not given,
// others do not, or nobody says how fast the aircraft climbs; where no ground is known, for
// places that are not near the origin, and where aircraft differ in how they begin: M300 and M350
// do not rise to the security height first.
FlownDji flown_dji(const DjiMission& mission, const MissionFrame& frame, const DjiRules& rules,
                   std::string_view source);

}  // namespace traj
