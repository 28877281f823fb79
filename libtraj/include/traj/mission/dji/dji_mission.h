#pragma once

// Waypoint missions of DJI: what their WPML files hold.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   const traj::DjiMission mission = traj::make_dji_mission(points, frame, {.speed = 6});
//   assert(mission.waylines[0].waypoints.size() == points.size());

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
#include "traj/mission/dji/dji_aircraft.h"

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

// A take-off straight up to the first point's height (to the security height where that is more),
// level flight to above that point where the take-off is elsewhere, a stop at each point, a
// landing: as the file will hold them, degrees rounded to 1e-9, heights to millimetres, above the
// take-off. At least one point, in ENU.
// Coordinated turns (options.turns may be empty: none) begin at most 0.45 of the shorter leg before
// their point, and are stops where that is less than kDjiLeastTurn.
DjiMission make_dji_mission(std::span<const geom::Vec3> points, const MissionFrame& frame,
                            const DjiOptions& options);

}  // namespace traj
