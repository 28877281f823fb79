#pragma once

// Mission Planner's texts of fences and rally points, which begin as missions do.

#include <string_view>

namespace cli {

// Whether a text that begins like this has no items but home, fences (MAV_CMD 5000 to 5004) and
// rally points (5100), as far as it is there.
bool is_fence_text(std::string_view head);

}  // namespace cli
