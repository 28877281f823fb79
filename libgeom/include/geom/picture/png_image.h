#pragma once

// Pictures as PNG, written and read.
//
// Example:
//   geom::picture::Picture picture{2, 1, {{255, 0, 0}, {0, 0, 255}}, {}, {}};
//   const std::string png = geom::picture::colour_png(picture);
//   assert(geom::picture::read_png(png, "two.png").rgb[0] == 255);

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geom/picture/picture.h"

namespace geom::picture {

std::string colour_png(const Picture& picture);  // 8 bits a channel, sRGB

// 16-bit grey: depth over `unit` metres, rounded; 0 where nothing is seen or it is 65,535.5 units
// away or more.
std::string depth_png(const Picture& picture, double unit);

// The ids as colours: red + 256 green + 65536 blue. All ids are below 2^24 (precondition).
std::string id_png(const Picture& picture);

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // rows from the top, 8 bits a channel
};
// Any PNG; transparent parts are black. Throws geom::InputError(name, …) where it is none, is
// damaged, or has more than 2^26 pixels.
Pixels read_png(std::string_view bytes, std::string_view name);

}  // namespace geom::picture
