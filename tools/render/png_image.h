#pragma once

// Pictures as PNG.

#include <string>

#include "render/picture.h"

namespace render {

std::string colour_png(const Picture& picture);  // 8 bits a channel, sRGB

// 16-bit grey: depth over `unit` metres, rounded; 0 where nothing is seen or it is 65,535.5 units
// away or more.
std::string depth_png(const Picture& picture, double unit);

// The ids as colours: red + 256 green + 65536 blue. All ids are below 2^24 (precondition).
std::string id_png(const Picture& picture);

}  // namespace render
