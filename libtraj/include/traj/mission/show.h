#pragma once

// A show: many flights that start together, as one file each and a list of when each begins.
//
// Example:
//   traj::ShowFlight a{.id = "a", .file = "a.csv", .planned = trajectory};
//   a.flown = trajectory;
//   a.room = scene.half();
//   const traj::ShowFlight show[] = {a};
//   assert(traj::check_show(show, {}, traj::Parked::pad).result.ok());
//   std::cout << traj::show_yaml(show, {.checked = true});

#include <span>
#include <string>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "geom/record/flight_time.h"
#include "traj/mission/export_mission.h"
#include "traj/record/pair_record.h"

namespace traj {

// One flight of a show, as its file will be flown.
struct ShowFlight {
  std::string id;
  std::string file;             // its name in the folder of the show
  geom::FlightTime time = {};   // of its record; a flight without a start begins at 0
  Trajectory planned = {};      // east, north, up
  Trajectory flown = {};        // what its file says, in the map's axes
  Vec3 stray = Vec3::Zero();    // metres along each axis that the drone's rounding may add
  Vec3 room = Vec3::Zero();     // half sizes with the margin, and the stray
  Vec3 vehicle = Vec3::Zero();  // half sizes without both
};

// Reads a written file again: sets `flown`, `stray`, `room` and `vehicle` of the flight. The format
// must be one of curves. `scene` is the one that the file was proved over.
ShowFlight read_back(ShowFlight flight, const geom::CollisionScene& scene,
                     const MissionFormat& format, const WrittenMission& written);

struct ShowCheck {
  TogetherTask task;
  TogetherResult result;
};

// Whether every pair keeps apart, started at their times and flown as the files say. The zones of
// `spacing` are grown by what the rounding of two files may add; rooms have it already. Throws
// UsageError for a zone that is smaller than two of the vehicles.
ShowCheck check_show(std::span<const ShowFlight> flights, const Spacing& spacing, Parked parked,
                     const geom::Execution& run = {});

// What the list of a show says of the proof.
struct ShowClaim {
  bool checked = false;  // clear of a map, and apart
  Spacing spacing = {};  // by how much
  double spare = 0;      // metres of the margin that need not be kept
  Parked parked = Parked::pad;
};

// When each file begins, in seconds after one instant, and from where to where it goes: YAML 1.1,
// in the order of the starts. There is at least one flight, and none is empty.
std::string show_yaml(std::span<const ShowFlight> flights, const ShowClaim& claim);

}  // namespace traj
