#pragma once

// MAVLink missions: what WPL files and QGroundControl plans hold.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   const traj::Mission mission = traj::make_mission(points, frame, {.landing_on = 0, .speed = 6});
//   for (const traj::MissionItem& item : mission.items) {
//     if (!traj::moves_nothing(item.command)) std::cout << item.altitude << " m\n";
//   }

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "traj/curve/mission_frame.h"
#include "traj/curve/trajectory.h"
#include "traj/mission/flown/fence.h"

namespace traj {

// MAV_FRAME: heights above sea level, above home, above the ground below.
enum MavFrame {
  kGlobal = 0,
  kMissionFrame = 2,
  kGlobalRelative = 3,
  kGlobalInt = 5,
  kGlobalRelativeInt = 6,
  kGlobalTerrain = 10,
  kGlobalTerrainInt = 11
};
// MAV_CMD, by what they do.
enum MavCommand {
  // Of missions: flown, or obeyed.
  kWaypoint = 16,
  kLoiterForever = 17,
  kLoiterTurns = 18,
  kLoiterTime = 19,
  kReturn = 20,
  kLand = 21,
  kTakeoff = 22,
  kLoiterToHeight = 31,
  kSplineWaypoint = 82,
  kDelay = 93,
  kPayloadPlace = 94,
  kJump = 177,
  kSpeed = 178,
  // Of missions: what changes no place and no height (moves_nothing).
  kConditionDelay = 112,
  kConditionDistance = 114,
  kConditionYaw = 115,
  kSetRelay = 181,
  kRepeatRelay = 182,
  kSetServo = 183,
  kRepeatServo = 184,
  kLandingStart = 189,
  kLookAtPlace = 195,  // a region of interest
  kLookAtNext = 196,
  kLookAtNothing = 197,
  kControlVideo = 200,
  kLookAt = 201,
  kConfigureCamera = 202,
  kControlCamera = 203,
  kConfigureMount = 204,
  kControlMount = 205,
  kTriggerByDistance = 206,
  kEnableFence = 207,
  kGripper = 211,
  kTriggerByTime = 214,
  kAuxFunction = 218,  // of ArduPilot; some functions move nothing
  kCameraMode = 530,
  kCameraZoom = 531,
  kCameraFocus = 532,
  kJumpTag = 600,
  kGimbalAngles = 1000,
  kConfigureGimbal = 1001,
  kStartImages = 2000,
  kStopImages = 2001,
  kControlTrigger = 2003,
  kStartVideo = 2500,
  kStopVideo = 2501,
  // Of fences and rally points.
  kFenceReturn = 5000,  // where a vehicle goes that left its fence
  kCornerToStayIn = 5001,
  kCornerToStayOut = 5002,
  kCircleToStayIn = 5003,
  kCircleToStayOut = 5004,
  kRallyPoint = 5100
};

// Whether it is one of those that change no place and no height.
bool moves_nothing(int command);

// An item as it stands in a file. NaN: the file says null.
struct MissionItem {
  int frame = kGlobalRelative;
  int command = kWaypoint;
  std::array<double, 4> param{};
  double latitude = 0;     // degrees
  double longitude = 0;    // degrees
  double altitude = 0;     // m
  std::size_t line = 0;    // where it was read; 0: it has none
  std::size_t number = 0;  // as the file counts, and jumps do
  std::size_t point = 0;   // of the path that make_mission made it of
  bool goes_on = true;     // to the next item by itself (autocontinue), which ArduPilot always does
};

struct Mission {
  std::optional<geom::GeodeticPlace> home;  // height above sea level
  std::vector<MissionItem> items;
  std::vector<GeodeticFence> fences;
  std::vector<geom::GeodeticPlace> rally;  // where a return may go; heights above home
  std::vector<std::string> notes;          // what a reader met that its user should know
  // The first item stands where ArduPilot and QGroundControl have home: they do not fly it.
  bool first_for_home = false;
};

struct MissionOptions {
  double home = 0;                   // z of the ground under the first point, m
  std::optional<double> landing_on;  // z of the ground under the last; absent: it hovers there
  std::optional<double> speed;       // m/s along the legs; absent: as the vehicle is set
  double hold = 3;                   // s to rest at a waypoint, so that no corner is cut there
  double acceptance = 2;             // m from a waypoint that count as there
  // Of each point whether it is passed without a rest; empty: none is. The first and the last rest.
  std::vector<bool> passed;
  // Of each point the speed with which it is come to, m/s; 0 or empty: as every leg is flown. The
  // way to slow down on is the leg's last `slowing` metres, behind a waypoint that is passed.
  std::vector<double> approach;
  double slowing = 30;
};

// A take-off straight up to the first point and a rest there, since autopilots pass the take-off
// before it is reached; the others as waypoints, relative to home; a landing: as the file will hold
// them, latitudes and longitudes rounded to 1e-7 degrees (as MAVLink sends them), heights to
// millimetres. At least one point, in ENU.
Mission make_mission(std::span<const Vec3> points, const MissionFrame& frame,
                     const MissionOptions& options);

}  // namespace traj
