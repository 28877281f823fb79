#pragma once

// Why a drone file was refused, in words.

#include <string>
#include <string_view>

#include "geom/collision/collision.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

// "horizontal speed" of "horizontal_speed".
std::string in_words(std::string_view quantity);

// The place, the reason and what to do: "flown as the file says, …". Times of straight legs are
// their numbers.
std::string refusal(const geom::CollisionScene& scene, const MissionTask& task,
                    const CheckResult& result);

}  // namespace traj
