#pragma once

// Whether the bytes of a drone file are flown clear of the map.

#include <string>
#include <string_view>
#include <utility>

#include "geom/collision/collision.h"
#include "traj/proof/check.h"
#include "writer.h"

namespace exporting {

// The file and the verdict on what its bytes, read again, make the drone fly ("end": straight legs
// that end over 2 cm from the goal). Straight legs are tried with the tolerance asked for or, where
// that fails, with points moved off what the legs would cut, and with ever finer legs; a path as it
// is, then with its points moved off by up to the tolerance.
std::pair<Written, traj::CheckResult> write_proved(const geom::CollisionScene& scene,
                                                   const Task& task);

// "horizontal speed" of "horizontal_speed".
std::string in_words(std::string_view quantity);

// The place, the reason and what to do, in words. Times of straight legs are their numbers.
std::string refusal(const geom::CollisionScene& scene, const Task& task,
                    const traj::CheckResult& result);

}  // namespace exporting
