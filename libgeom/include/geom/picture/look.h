#pragma once

// How the things of a map look: what a shader paints them with.
//
// Example:
//   geom::picture::Look look = geom::picture::look_of(map);
//   look.windows.assign(map.size(), false);
//   assert(look.colour.size() == map.size());

#include <vector>

#include "geom/map/box_map.h"
#include "geom/picture/grid_lines.h"
#include "geom/picture/picture.h"

namespace geom::picture {

struct Look {
  std::vector<Colour> colour;  // one a box
  std::vector<bool> windows;   // whether a box wears them
  Aabb ground;                 // ENU: the part of the ground that is the map's
  GridLines grid;
};

// A colour a box: by its label where it has one, else by the height of its top.
std::vector<Colour> box_colours(const BoxMap& map);

Look look_of(const BoxMap& map);

}  // namespace geom::picture
