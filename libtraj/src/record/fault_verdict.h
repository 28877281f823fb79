#pragma once

// What a check refuses, in words.

#include <string>
#include <string_view>

namespace traj {

// "horizontal speed" of "horizontal_speed".
std::string spoken(std::string_view quantity);

}  // namespace traj
