#pragma once

// Fences that come with missions: regions in which a vehicle must stay, or which it must avoid.
//
// Example:
//   const traj::GeodeticFence circle{.inclusion = true, .centre = {47.4, 8.5, 0}, .radius = 100};
//   const traj::Fence fence = traj::fence_on_map(circle, {47.4, 8.5, 400}, "mission.plan");
//   assert(fence.inclusion && fence.ring.size() == 256);

#include <string_view>
#include <vector>

#include "geom/map/geodetic_outline.h"

namespace traj {

// As it stands in a file, from the ground to the sky: a polygon, or a circle.
struct GeodeticFence {
  bool inclusion = false;                 // to stay in; else to stay out of
  std::vector<geom::GeodeticPlace> ring;  // empty: a circle
  geom::GeodeticPlace centre;
  double radius = 0;  // m
};

// A simple polygon, metres.
struct Fence {
  bool inclusion = false;
  std::vector<geom::Vec2> ring;
  double bulge = 0;  // how far its true edges may be from these
};

// geom::outline_on_map() on the safe side: the polygon of a circle lies around an exclusion, and
// within an inclusion. Throws geom::InputError(source, …) as that does.
Fence fence_on_map(const GeodeticFence& fence, const geom::GeodeticOrigin& origin,
                   std::string_view source);

using geom::is_near;

}  // namespace traj
