#pragma once

// What writing a drone file takes, and what comes out.
//
// Example:
//   traj::ExportOptions options;
//   options.placement.origin = geom::GeodeticOrigin{47.4, 8.5, 400};
//   options.speed = 5;  // m/s along straight legs
//   assert(traj::speed_limit({{traj::Limit::speed, 8}}) == 8);

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "traj/mission/dji/dji_mission.h"
#include "traj/mission/flown/fence.h"
#include "traj/mission/formats/crazyflie.h"
#include "traj/mission/formats/export_flight.h"
#include "traj/mission/formats/reading.h"
#include "traj/mission/mavlink/mission_time.h"
#include "traj/proof/limits.h"

namespace traj {

struct MissionFormat;
class TubeReports;

// What may be asked of a file. A format takes heed of what MissionFormat::writes_with has.
struct ExportOptions {
  Placement placement = {};
  Flier flier = {};                  // what will fly it
  double rate = 50;                  // setpoints a second, Hz
  bool ned = false;                  // of setpoints: north, east, down
  double tolerance = 0.2;            // m that straight legs may leave the curve, to begin with
  bool lands = true;                 // else it ends hovering
  std::optional<double> speed = {};  // m/s along straight legs; absent: what the limits allow
  DjiOptions dji = {};               // version and aircraft
  std::optional<double> turns = {};  // m of a DJI mission's turns without a stop
  std::size_t volumes = 8;           // of airspace, at most
  double buffer = 0;                 // m around the vehicle and its margin, of volumes of airspace
  // Tubes that volumes of airspace hold in place of the margin: the proved one of the trajectory.
  std::shared_ptr<const TubeReports> tubes = {};
  bool says_when = false;                  // a file beside this one says when the flight begins
  std::vector<GeodeticFence> fences = {};  // of a mission
  std::vector<Vec3> rally = {};            // likewise, in the air, in the map's axes
};

// All that the file of one flight is made of. The format and the flight are not owned.
struct MissionTask {
  const MissionFormat* format = nullptr;
  ExportOptions options;
  const ExportFlight* flight = nullptr;
  Trajectory enu;                // the flight's
  geom::Polyline path;           // likewise, where it is a path
  Limits limits;                 // that hold: the record's, the vehicle's
  geom::Frame frame;             // of the map, or what the record says of it
  double ground = 0;             // z under the first point
  double landing = 0;            // and under the last
  std::vector<bool> passed;      // of missions: MissionOptions
  std::vector<double> approach;  // likewise
  std::vector<double> turns;     // of DJI missions, m: as far as they are known to fit
  bool checked = true;
};

// How long a vehicle will take.
struct MissionEstimate {
  std::string autopilot;
  MissionTime time;
  bool at_least = false;  // what it takes to speed up, stop and turn is not known, and comes on top
};

struct WrittenMission {
  std::string text;         // the bytes of the file
  std::string python = {};  // of a Tello: a program, and
  std::string csv = {};     // a table, for those who ask for them
  std::string fences = {};  // of a mission without room for them: a file each
  std::string rally = {};
  std::string params = {};               // the autopilot's parameters, for those who ask for them
  std::string procedure = {};            // what happens if the link is lost, in words, likewise
  std::vector<std::size_t> points = {};  // of a mission: the path's point of each item
  MissionReading reading = {};           // what it takes to read the text again
  std::string note = {};                 // what is not as asked; empty: all is
  std::vector<MissionEstimate> estimates = {};  // of legs: one a vehicle that may fly them
  std::optional<CrazyflieMemory> memory = {};   // of a Crazyflie
};

// Whether somebody said how high above the ellipsoid the map's z = 0 is; else it counts as 0 m.
bool knows_height(const MissionTask& task);

// The largest speed that they allow in every direction, m/s.
std::optional<double> speed_limit(const Limits& limits);
// The same for the legs of a file. A vehicle that climbs and sinks no faster than the limits allow,
// whatever the file asks for (MissionFormat::climbs_at_most), leaves its vertical limit out.
std::optional<double> speed_along_legs(const MissionTask& task);

// "UNCHECKED: not compared with any map", or nothing.
std::string unchecked_note(const MissionTask& task);

// To read a file again: over the origin that it was written for, whose height counts as known. A
// mission says where home is.
Placement placement_to_read(const MissionTask& task, const MissionFrame& over);

}  // namespace traj
