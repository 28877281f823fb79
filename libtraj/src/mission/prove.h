#pragma once

// Whether the bytes of a drone file are flown clear of the map.

#include "geom/collision/collision.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// The file and the verdict on what its bytes, read again, make the drone fly: as export_mission.h
// says, with what the format does in its own way.
MissionProof write_proved(const geom::CollisionScene& scene, const MissionTask& task);

// What the bytes make the drone fly, in the axes of the task's frame. Throws geom::InputError for
// bytes that the format does not allow.
Flown read_again(const MissionTask& task, const WrittenMission& written);

inline constexpr double kEndGap = 0.02;  // m: how well straight legs must meet the ends

// m from where the legs end to the end of the flight; 0 for what has none.
double missed_end(const MissionTask& task, const Flown& flown);

}  // namespace traj
