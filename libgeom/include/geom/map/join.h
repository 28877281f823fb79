#pragma once

// Boxes of one map in the coordinates of another, to join maps.
//
// Example:
//   geom::BoxTable both = geom::table_of(map);
//   geom::append(both, geom::in_frame(map.spec().frame, map, "other.boxmap"));
//   assert(both.boxes.size() == 2 * map.size());

#include <span>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

// The boxes of `other` in the coordinates of `frame`. If the frames are equal, the boxes stay as
// they are. If both frames have an origin and count metres east and north of it (no CRS, or a
// transverse Mercator projection about the origin), each box becomes the box around its moved
// corners, and a little more for the bulge of its edges. If only one of the origins has a height
// (0 m: nobody knows it), and else, throws InputError(source, …), which says what differs.
BoxTable in_frame(const Frame& frame, const BoxMap& other, std::string_view source);

// A table of the map's boxes. If `region` is given, a table of the boxes that meet it.
BoxTable table_of(const BoxMap& map, const Aabb* region = nullptr);

}  // namespace geom
