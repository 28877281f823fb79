#pragma once

// Drawing over a picture: smooth lines and discs, and small letters.

#include <span>
#include <string_view>
#include <vector>

#include "geom/picture/picture.h"

namespace geom::picture {

struct Spot {  // pixels; the centre of pixel (i, j) is at (i, j)
  double x = 0;
  double y = 0;
};

struct Plate {       // a rectangle
  Spot corner;       // the upper left one
  double width = 0;  // pixels
  double height = 0;
};

void fill(Picture& picture, Colour colour);
// `share` of the colour: what is below shows through where it is less than 1.
void draw_rectangle(Picture& picture, const Plate& plate, Colour colour, double share = 1);
void draw_line(Picture& picture, std::span<const Spot> points, double width, Colour colour,
               double share = 1);
void draw_disc(Picture& picture, Spot centre, double radius, Colour colour, double share = 1);
// A circle of a line so wide, open in the middle.
void draw_ring(Picture& picture, Spot centre, double radius, double width, Colour colour,
               double share = 1);

// Letters (font.h) whose capitals are 8 pixels high, times `scale`, from the upper left corner of a
// capital.
void draw_text(Picture& picture, Spot corner, std::string_view words, int scale, Colour colour);
double text_width(std::string_view words, int scale);

// Puts `part` into `whole` with its upper left corner at (x, y), where it must fit.
void put(const Picture& part, int x, int y, Picture& whole);

}  // namespace geom::picture
