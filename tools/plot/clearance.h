#pragma once

// How near the obstacles a vehicle comes.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "traj/proof/clearance.h"

namespace plot {

struct ClearanceTrack {
  std::string id;
  std::vector<traj::ClearanceSpan> spans;  // at least one
};

// An SVG of the least distances as steps, for the vehicle and the margin of the scene; those over
// 50 m are shown as that.
std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label);

}  // namespace plot
