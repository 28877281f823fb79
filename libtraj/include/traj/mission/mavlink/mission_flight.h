#pragma once

// The flight of a vehicle on a mission: its legs, and the regions that it may fly through.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   const traj::Mission mission = traj::make_mission(points, frame, {.landing_on = 0});
//   const traj::FlownMission flown = traj::flown_mission(mission, frame, {}, "mission.plan");
//   assert(flown.drift.size() == 2);  // where PX4 and ArduPilot may be

#include <optional>
#include <string_view>
#include <vector>

#include "traj/mission/firmware/autopilot.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/flown/terrain_rules.h"
#include "traj/mission/mavlink/mission.h"

namespace traj {

// Settings of the vehicle that a file does not have, as far as the user gives them.
struct MissionRules {
  std::optional<double> home;           // z of home, for files that do not say it
  std::optional<double> acceptance;     // m from a waypoint where a turn may begin
  std::optional<double> speed;          // m/s, the most that is flown, where the file says none
  double braking = 3;                   // m/s2
  std::optional<double> return_height;  // m above home at which it returns
  std::optional<double> ground;  // z of the flat ground that heights above terrain count from
  std::optional<TerrainRules> terrain = {};               // or what is known of other ground
  std::vector<Autopilot> autopilots{px4(), ardupilot()};  // any of which may fly it
};

// In ENU, and what the mission leaves open, for its user.
struct FlownMavlink : FlownMission {
  bool takes_off = false;        // else how it comes to its first point is not known
  bool ended = false;            // by a landing, a return or loitering; else it may have been cut
  int not_for_px4 = 0;           // the command of the first item that PX4 does not fly; 0: none
  bool above_terrain = false;    // for that item's height
  bool counts_from_sea = false;  // heights of it depend on where the sea level is
  // m from home to the take-off's place, where those differ: it climbs at home and goes there. Some
  // autopilots take no heed of a take-off's place and go on from above home.
  double takeoff_from_home = 0;
  std::size_t tight_radii = 0;  // items with a radius at which PX4 leaves the line before them
};

// PX4's default radius of acceptance (NAV_ACC_RAD), the largest of those in use; ArduPilot's
// (WPNAV_RADIUS) is 2 m.
inline constexpr double kAcceptance = 10;      // m
inline constexpr double kLeastAcceptance = 2;  // m
// ArduPilot's default speed along legs (WPNAV_SPEED); PX4's (MPC_XY_CRUISE) is 5 m/s.
inline constexpr double kUnsaidSpeed = 10;  // m/s

// A multirotor's flight, by PX4's and ArduPilot Copter's documents of mission commands:
// - Legs are straight. At a waypoint with a hold of at least 1 s, and of twice what braking within
//   its radius takes, the vehicle rests: PX4 counts the hold from where it comes within the radius.
//   At others it may turn within the radius of acceptance: the one of `rules`, else 2 m
//   (kLeastAcceptance) beside an item's own, else kAcceptance; and never less than the item's own,
//   which PX4 takes and ArduPilot does not. The triangle of the corner within that radius is swept,
//   and as much of the old leg beyond the waypoint as speed^2 / (2 braking) is more than the least
//   of those radii. 0: it goes to the point. After a shorter hold or a delay it goes on from
//   anywhere within the radius. Points so near to each other that several may count as reached
//   while it turns are passed straight on.
// - A spline (ArduPilot's SplineCurve) is swept as the hull of its Bezier points, tangents as long
//   as they may be: four times the leg at most.
// - Turns on a circle (ArduPilot): in straight to the nearest point of the circle, around, and on
//   from there; arcs are swept between chord and tangents. Whole turns, from outside of half the
//   radius. Loitering for a time or for ever: on the spot, or on the circle of the radius that is
//   given, or anywhere in it.
// - A payload's place (ArduPilot): to above it at the present height, down until it touches, up
//   again to that height. Home's ground must be there (judge.h).
// - Jumps are unrolled, a jump for ever twice. A mission of more than kMostItems items with all
//   jumps taken is refused.
// - A return climbs to `return_height` above home, where it is lower, goes straight above home, and
//   lands there; nearer to home than that is high, it may return at any height from its own to that
//   (PX4's RTL_CONE_ANG of 45 degrees, ArduCopter's cone). As sweeps, likewise to each rally point
//   of the file, down to its height; it must find home's ground below (judge.h). Without that
//   height, or with the mark of a landing (189) that it may go to: `returns`.
// Commands that are known to move nothing (cameras, gimbals, servos, yaw) are counted.
// - Changes of speed: what each of the autopilots makes of them; behind a condition, at which
//   ArduPilot may come late or never, the larger of both speeds.
// - PX4 loads no mission with a spline, turns on a circle, a payload's place or an auxiliary
//   function, and flies to a take-off at latitude 0, longitude 0: such a mission is ArduPilot's
//   alone, which rests at each hold of 1 s.
// - ArduPilot takes an altitude of 0 for the present one, and latitude 0, longitude 0 for the
//   present place; PX4 takes both as they stand. So these are refused where both may fly it.
//
// - Heights above terrain are ArduPilot's alone, since PX4 loads no mission with them. Without
//   `ground` the flight is a band of heights over the terrain of `terrain`: home's height, the
//   heights of the items, and how much higher the autopilot may take the terrain to be than at
//   home. All waypoints must count from the terrain. A return is known where the last of them is
//   a rest and it is flown above all heights at which it may begin.
//
// Throws geom::InputError(source, line, …) for all others (changes of mode, unknown ones), for
// items after the end of the flight, a second take-off, heights above terrain without `ground` and
// `terrain`, places that are not near the origin, a height above home without home, and a way
// beyond a fence of the autopilots' parameters.
FlownMavlink flown_mission(const Mission& mission, const MissionFrame& frame,
                           const MissionRules& rules, std::string_view source);

inline constexpr std::size_t kMostItems = 1'000'000;

}  // namespace traj
