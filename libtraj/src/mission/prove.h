#pragma once

// Whether the bytes of a drone file are flown clear of the map.

#include "geom/collision/collision.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// The file and the verdict on what its bytes, read again, make the drone fly: as export_mission.h
// says, with what the format does in its own way.
MissionProof write_proved(const geom::CollisionScene& scene, const MissionTask& task);

}  // namespace traj
