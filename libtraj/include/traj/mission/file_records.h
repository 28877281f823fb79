#pragma once

// The flights of a drone file as records of paths, trajectories and corridors.
//
// They are made for the aircraft that the file names: made_for() throws where the provenance has a
// smaller vehicle.
//
// Example:
//   traj::FlownLegs legs;
//   legs.path = path;
//   const traj::FileFlight file{"q1", traj::mission_format_named("tello"), {legs}, {}};
//   const auto record = traj::path_record(file, geom::provenance_of(scene));
//   assert(record && record->points == path);

#include <optional>

#include "geom/record/record.h"
#include "traj/mission/read_mission.h"
#include "traj/record/corridor_record.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// The straight legs of the flight, with their holds. Nothing if it has none. The ascent before and
// the descent after them are part of the path if `with_ends`, as skyway-check counts its legs; the
// holds are left out then.
std::optional<geom::PathRecord> path_record(const FileFlight& file,
                                            const geom::Provenance& provenance,
                                            bool with_ends = false);

// The curve of the flight, or the straight ways between its setpoints. Empty for legs.
TrajectoryRecord trajectory_record(const FileFlight& file, const geom::Provenance& provenance);

// The regions beside the legs of a mission in which the vehicle may be, as they are drawn: its
// sweeps or, above terrain, the band of heights of each leg, as an upright face. Nothing if there
// are none.
std::optional<CorridorShape> regions_record(const FileFlight& file,
                                            const geom::Provenance& provenance);

}  // namespace traj
