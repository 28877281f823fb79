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
// 50 m are shown as that. The last metre (or twice the margin) has nearly half of the height; what
// is less than the margin, by more than a millimetre, is shaded and said. `x_label` ends in its
// unit; `note` stands after the title.
std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label, std::string_view note = "");

}  // namespace plot
