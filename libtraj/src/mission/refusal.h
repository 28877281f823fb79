#pragma once

// Why a drone file was refused, in words.

#include <string>

#include "geom/collision/collision.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// The place, the reason and what to do: "flown as the file says, …". Times of straight legs are
// their numbers.
std::string refusal(const geom::CollisionScene& scene, const MissionTask& task,
                    const CheckResult& result);

}  // namespace traj
