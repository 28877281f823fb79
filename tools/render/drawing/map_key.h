#pragma once

// What makes a picture a map: a scale bar, an arrow to the north, how wide the grid is, and what
// the discs at the ends of the ways mean.

#include <string>

#include "canvas.h"
#include "render/camera/view.h"
#include "render/scene/ground_grid.h"

namespace render {

struct MapKey {
  geom::Aabb ground;  // ENU: the map's bounds, or what of them is shown
  GroundGrid grid;
  bool ways = false;  // there are starts and goals
};

// "250 m", "2 km", "0.05 m".
std::string length_words(double metres);

// The scale of letters and marks for a picture; 0 where it is too small (240 pixels) for a key.
int key_scale(const Picture& picture);

// On a plan the bar lies in the lower left corner; in an overview it lies on the ground along the
// edge of the map that is nearest, and is true there. Nothing on a picture that is too small.
void draw_map_key(Picture& picture, const View& view, const MapKey& key);

}  // namespace render
