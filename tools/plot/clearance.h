#pragma once

// How near the obstacles a vehicle comes.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/collision.h"

namespace plot {

struct ClearanceTrack {
  std::string id;
  std::vector<double> x;           // seconds or metres, ascending
  std::vector<geom::Vec3> points;  // in the map's frame, one each
};

// An SVG of the distance from the reference point to the nearest obstacle grown by the vehicle of
// the scene, without its margin, at each point; distances over 50 m are shown as that. A picture,
// no proof: between the points it knows nothing.
std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label);

}  // namespace plot
