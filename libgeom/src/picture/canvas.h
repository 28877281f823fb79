#pragma once

// Drawing over a picture: smooth lines and discs, and small letters.

#include <span>
#include <string_view>

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

struct Paint {
  Paint(Colour of, double so_much = 1) : colour(of), share(so_much) {}

  Colour colour;
  double share;  // of it: what is below shows through where it is less than 1
};

struct Ring {  // a circle of a line, open in the middle
  Spot centre;
  double radius = 0;
  double width = 0;
};

struct Lettering {
  int scale = 1;  // capitals are 8 times as many pixels high
  Colour colour{};
};

void fill(Picture& picture, Colour colour);
void draw_rectangle(Picture& picture, const Plate& plate, const Paint& paint);
void draw_line(Picture& picture, std::span<const Spot> points, double width, const Paint& paint);
void draw_disc(Picture& picture, Spot centre, double radius, const Paint& paint);
void draw_ring(Picture& picture, const Ring& ring, const Paint& paint);

// Letters of font.h, from the upper left corner of a capital.
void draw_text(Picture& picture, Spot corner, std::string_view words, const Lettering& letters);
double text_width(std::string_view words, int scale);

// Puts `part` into `whole` with its upper left corner at (x, y), where it must fit.
void put(const Picture& part, int x, int y, Picture& whole);

}  // namespace geom::picture
