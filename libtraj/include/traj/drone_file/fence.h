#pragma once

// Fences that come with missions: where a vehicle must stay, and what it must stay out of.

#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polygon.h"

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

// In ENU about the origin. A circle becomes a polygon of 256 corners: around it where it is to be
// stayed out of, within it else, 0.0075 % of its radius on the safe side. Some autopilots take
// edges as straight in degrees, others in metres, and a map's metres grow away from its origin;
// `bulge` bounds both. Throws
// geom::InputError(source, …) for a ring of fewer than 3 places or with crossing edges, a radius
// that is not above 0 or beyond 100 km, and a place that is not near the origin.
Fence fence_on_map(const GeodeticFence& fence, const geom::GeodeticOrigin& origin,
                   std::string_view source);

// Whether that is a place on Earth within 10 degrees of latitude and 20 of longitude of the origin.
bool is_near(const geom::GeodeticOrigin& origin, double latitude, double longitude);

}  // namespace traj
