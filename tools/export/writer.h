#pragma once

// From a trajectory to the bytes of a drone file.

#include <string>
#include <vector>

#include "cli/content/drone_file.h"
#include "traj/curve/trajectory.h"
#include "traj/drone_file/dji_mission.h"
#include "traj/drone_file/mission_time.h"
#include "traj/proof/limits.h"

namespace exporting {

struct Task {
  std::string format;
  std::string id;
  traj::Trajectory enu;
  geom::Polyline path;  // ENU: what the trajectory runs through where it was made of a path
  traj::Limits limits;
  cli::Placement placement;
  geom::Frame frame;       // of the map, or what the record says of it
  double rate = 50;        // setpoints a second, Hz
  bool ned = false;        // setpoints
  double tolerance = 0.2;  // m that straight legs may leave the curve, to begin with
  double ground = 0;       // z under the first point
  double landing = 0;      // and under the last
  bool lands = true;
  std::optional<double> speed;      // m/s
  std::vector<bool> passed;         // of missions: traj::MissionOptions
  std::vector<double> approach;     // likewise
  cli::AutopilotOptions autopilot;  // what will fly it
  traj::DjiOptions dji;             // version, aircraft, and turns as far as they are known to fit
  std::optional<double> turns;      // m, asked for
  std::size_t volumes = 8;          // of airspace, at most
  double buffer = 0;                // m around the vehicle and its margin, of volumes of airspace
  bool checked = true;
};

// How long an autopilot will take.
struct Estimate {
  std::string autopilot;
  traj::MissionTime time;
};

struct Written {
  std::string text;
  // Of a Tello: a program and a table, for those who ask for them.
  std::string python;
  std::string csv;
  std::vector<std::size_t> points = {};  // of a mission: the path's point of each item
  cli::DroneFileOptions reading;         // what it takes to read the text again
  std::string note = {};                 // what is not as asked; empty: all is
  std::vector<Estimate> estimates = {};  // of a mission: one an autopilot that may fly it
};

// Whether somebody said how high above the ellipsoid the map's z = 0 is; else it counts as 0 m.
bool knows_height(const Task& task);

// The largest speed that they allow in every direction, m/s.
std::optional<double> speed_limit(const traj::Limits& limits);

// The speed along a mission's legs, m/s: as asked, else what the limits allow. That on climbing and
// descending does not count where the autopilots keep it by themselves.
std::optional<double> mission_speed(const Task& task);

// Whether the format is straight legs, rather than the curve itself.
bool has_legs(const std::string& format);

// `legs` in ENU, for formats that have them. Throws cli::UsageError where the task lacks what the
// format needs.
Written write(const Task& task, const geom::Polyline& legs);

}  // namespace exporting
