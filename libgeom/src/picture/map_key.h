#pragma once

// What makes a picture a map: a scale bar, an arrow to the north, how wide the grid is, and what
// the discs at the ends of the ways mean.

#include <string>

#include "canvas.h"
#include "geom/picture/grid_lines.h"
#include "geom/picture/view.h"

namespace geom::picture {

struct MapKey {
  Aabb ground;  // ENU: the map's bounds, or what of them is shown
  GridLines grid;
  bool ways = false;  // there are starts and goals
};

// "250 m", "2 km", "0.05 m".
std::string length_words(double metres);

// The scale of letters and marks for a picture; 0 where it is too small (240 pixels) for a key.
int key_scale(const Picture& picture);

// How many rows of such a picture the key takes, below the map; 0 where the picture is too small.
int key_band(int width, int height);

// The key stands in a band below the map (key_band): in it a plan's bar, what marks mean, the grid
// and the arrow to the north. An overview's bar lies on the ground along the edge of the map that
// is nearest, and is true there. Nothing on a picture that is too small.
void draw_map_key(Picture& picture, const View& view, const MapKey& key);

}  // namespace geom::picture
