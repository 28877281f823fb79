#pragma once

// How the things of a map look: what a shader paints them with.

#include <vector>

#include "geom/map/box_map.h"
#include "ground_grid.h"
#include "render/image/picture.h"

namespace render {

struct Look {
  std::vector<Colour> colour;  // one a box
  std::vector<bool> windows;   // whether a box wears them
  geom::Aabb ground;           // ENU: the part of the ground that is the map's
  GroundGrid grid;
};

// A colour a box: by its label where it has one, else by the height of its top.
std::vector<Colour> box_colours(const geom::BoxMap& map);

Look look_of(const geom::BoxMap& map);

}  // namespace render
