#pragma once

// Waypoint missions of DJI: what their WPML files hold, and what an aircraft makes of them.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   const traj::DjiMission mission = traj::make_dji_mission(points, frame, {.speed = 6});
//   const traj::FlownDji flown = traj::flown_dji(mission, frame, {.ground = 0}, "mission.kmz");
//   assert(flown.path.size() >= points.size());

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polyline.h"
#include "geom/text/words.h"
#include "traj/curve/mission_frame.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/flown/terrain_rules.h"

namespace traj {

// executeHeightMode: WGS84, relativeToStartPoint, realTimeFollowSurface.
enum class DjiHeights { ellipsoid, above_takeoff, above_surface };
// flyToWaylineMode
enum class DjiApproach { safely, point_to_point };
// finishAction
enum class DjiFinish { go_home, hover, land, first_waypoint };

// waypointTurnMode: toPointAndStopWithDiscontinuityCurvature, coordinateTurn, and
// toPointAndPassWithContinuityCurvature on straight legs.
enum class DjiTurn { stop, early, through };

struct DjiWaypoint {
  double latitude = 0;   // degrees
  double longitude = 0;  // degrees
  double height = 0;     // m, as the wayline's heights count; not used above the surface
  double speed = 0;      // m/s from here to the next
  double hover = 0;      // s, beside the stop to turn
  std::size_t line = 0;  // where it was read
  DjiTurn turn = DjiTurn::stop;
  double damping = 0;  // m from the waypoint where a turn without a stop begins and ends
};

struct DjiWayline {
  int template_id = 0;  // of what it was made of
  DjiHeights heights = DjiHeights::above_takeoff;
  std::vector<DjiWaypoint> waypoints;  // at least one
  double hover_before = 0;             // s, at the first of them
};

// droneEnumValue and droneSubEnumValue.
struct DjiAircraft {
  int type = 77;  // Mavic 3 Enterprise
  int kind = 0;

  bool operator==(const DjiAircraft&) const = default;
};

// The aircraft that have a name: DJI's enumeration, in its cloud API documentation of WPML (common
// element).
struct NamedDjiAircraft {
  std::string_view name;
  DjiAircraft aircraft;
  int camera = 0;  // payloadEnumValue of its own
};
inline constexpr NamedDjiAircraft kDjiAircraft[] = {
    {"m30", {67, 0}, 52}, {"m30t", {67, 1}, 53}, {"m3e", {77, 0}, 66}, {"m3t", {77, 1}, 67},
    {"m3m", {77, 2}, 68}, {"m3d", {91, 0}, 80},  {"m3td", {91, 1}, 81}};

// What is known of all aircraft of a type (droneEnumValue): the profile of data/vehicles that holds
// them, and the most that they climb and sink, m/s, as DJI publishes it (of type 91 an assumption).
struct DjiAirframe {
  int type = 0;
  std::string_view vehicle;
  double climb = 0;
  double descent = 0;
};
inline constexpr DjiAirframe kDjiAirframes[] = {{67, "m30", 6, 5},
                                                {77, "m3e", 6, 6},
                                                {89, "m350", 6, 5},
                                                {91, "m3d", 8, 8},
                                                {99, "m4e", 10, 8}};
// Null for a type that is not known.
const DjiAirframe* airframe_of(const DjiAircraft& aircraft);
// The word of --vehicle for an aircraft: its name if it has one, else that of its airframe's
// profile. Empty for a type that is not known.
std::string_view vehicle_of(const DjiAircraft& aircraft);

// What an aircraft does when it loses its controller: exitOnRCLost and executeRCLostAction. It goes
// on with the mission (goContinue), or leaves it (goBack, landing, hover): that way is not proved.
enum class DjiLostLink { go_back, go_on, land, hover };
inline constexpr geom::Words<DjiLostLink, 4> kDjiLostLinkWords{{
    {DjiLostLink::go_back, "return"},
    {DjiLostLink::go_on, "continue"},
    {DjiLostLink::land, "land"},
    {DjiLostLink::hover, "hover"},
}};

// The versions of WPML that are written.
inline constexpr std::string_view kWrittenWpmlVersions[] = {"1.0.2", "1.0.6"};

struct DjiMission {
  std::string version = "1.0.6";  // of WPML
  DjiAircraft aircraft;
  DjiApproach approach = DjiApproach::safely;
  DjiFinish finish = DjiFinish::hover;
  double security_height = 20;                 // m above the take-off
  double transit_speed = 0;                    // m/s to the first waypoint of a wayline
  std::optional<double> return_height;         // m above the take-off
  std::optional<geom::GeodeticPlace> takeoff;  // that was planned with; height on the ellipsoid
  std::string without_link;          // what it does when it loses the controller, as the file says
  std::optional<double> gimbal;      // degrees of pitch from the first waypoint on; 0: level
  std::optional<double> nose;        // degrees clockwise from north; else along the way
  std::vector<DjiWayline> waylines;  // at least one, flown one after the other
  std::size_t actions = 0;           // of cameras, gimbals and yaw: they move the aircraft nowhere
};

inline constexpr double kDjiFastest = 15;  // m/s, of globalTransitionalSpeed

inline constexpr double kDjiLeastTurn = 0.2;  // m, of those that are written

// How a mission is laid over a map: what may be asked for.
struct DjiOptions {
  double home = 0;              // z of the ground at the take-off, m
  bool lands = true;            // where the last point is; else it hovers there
  std::vector<double> turns;    // m, one a point: the longest damping of its turn; 0: it stops
  std::optional<double> speed;  // m/s, no more than kDjiFastest is written; absent: 5
  std::string version = "1.0.6";
  DjiAircraft aircraft;
  std::optional<geom::Vec3> takeoff;  // where it stands before, ENU; else under the first point
  DjiLostLink lost_link = DjiLostLink::go_back;
  std::optional<double> gimbal;  // degrees of pitch, kDjiGimbalDown to kDjiGimbalUp
  std::optional<double> nose;    // degrees clockwise from north; else it looks along its way
};

// What gimbals of the aircraft that have a name can do, as far as all of them can: degrees.
inline constexpr double kDjiGimbalDown = -90;
inline constexpr double kDjiGimbalUp = 30;

// A take-off straight up to the first point's height (to the security height where that is more),
// level flight to above that point where the take-off is elsewhere, a stop at each point, a
// landing: as the file will hold them,
// degrees rounded to 1e-9, heights to millimetres, above the take-off. At least one point, in ENU.
// Coordinated turns (options.turns may be empty: none) begin at most 0.45 of the shorter leg before
// their point, and are stops where that is less than kDjiLeastTurn.
DjiMission make_dji_mission(std::span<const Vec3> points, const MissionFrame& frame,
                            const DjiOptions& options);

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
// between
//   the waypoint and the places at waypointTurnDampingDist before and behind it; one that passes
//   through the waypoint, which may swing wide, within that distance of it in plan and within the
//   difference of these places' heights beyond them. No two turns of a leg may meet.
// - An aircraft whose airframe is known climbs and sinks no faster than that does, whatever speed
// the
//   file asks for.
// - goHome rises to globalRTHHeight (else `return_height`) where it is lower, flies level to above
//   home, and lands. Within 50 m of home some aircraft do not rise: all heights between are swept.
// - realTimeFollowSurface: DJI states no bound for this. The aircraft is where `surface` says,
//   whatever executeHeight is. It rises to takeOffSecurityHeight, goes above
//   the first waypoint and into the band of heights; on the way it may be anywhere in the upright
//   face between. Each leg is in pieces of at most 5 m, each with the heights over the ground
//   below it. From one wayline to the next it may be at any height that it may have on the way.
//   A return begins anywhere in the band, and is flown at any of the heights to which it rises.
// A return from within 20 m of home, where some land at once, or without a height is no way that is
// known (`returns`). Nor is gotoFirstWaypoint.
//   The take-off must be on that ground within 5 m, or they count from different zeros.
// Throws geom::InputError(source, …) where the file says another height of the return than
// `return_height`; with a line, where waylines follow the surface and `surface` is not
// given, others do not, or nobody says how fast the aircraft climbs; where no ground is known, for
// places that are not near the origin, and where aircraft differ in how they begin: M300 and M350
// do not rise to the security height first.
FlownDji flown_dji(const DjiMission& mission, const MissionFrame& frame, const DjiRules& rules,
                   std::string_view source);

}  // namespace traj
