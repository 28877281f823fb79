#pragma once

// The least clearance along a way, as rows of a CSV table.
//
// Example:
//   const auto spans = traj::clearance_profile(scene, trajectory, 0.5);  // each half second
//   std::cout << traj::kProfileHead << traj::profile_rows("q1", spans);

#include <span>
#include <string>
#include <string_view>

#include "traj/proof/clearance.h"

namespace traj {

// The names of the columns: seconds, or metres along a path, and metres to the obstacles.
inline constexpr std::string_view kProfileHead = "id,begin,end,clearance_m\n";

// A row for each part, with the shortest digits that read back as the same number.
std::string profile_rows(std::string_view id, std::span<const ClearanceSpan> spans);

}  // namespace traj
