#pragma once

// Latitudes and longitudes that stand where metres are expected.
//
// Example:
//   geom::Frame frame;
//   frame.origin = geom::GeodeticOrigin{60.17, 24.94, 0};
//   const std::vector<geom::Vec3> points = {{60.171, 24.941, 30}};
//   assert(geom::look_like_degrees(frame, points));

#include <optional>
#include <span>
#include <string>

#include "geom/map/frame.h"

namespace geom {

// Whether all points, of which there is one at least, read as the latitude and longitude (in either
// order) of places within half a degree of the frame's origin, and none of these numbers is whole.
// Of points that are metres, spread over a square kilometre, one in a million reads so.
bool look_like_degrees(const Frame& frame, std::span<const Vec3> points);

// The rectangle around the corners of one volume where these may be degrees, although nobody knows
// the frame's origin: it is less than 2 across, and none of its numbers is whole.
struct SmallOutline {
  Vec3 low;
  Vec3 high;
};
std::optional<SmallOutline> may_be_degrees(std::span<const Vec3> corners);

}  // namespace geom
