#pragma once

// Pictures as the bytes of files: PFM, YUV4MPEG2.
//
// Example:
//   geom::picture::Picture picture{.width = 2, .height = 1, .depth = {1.5f, 0}};
//   assert(geom::picture::pfm(picture).starts_with("Pf\n2 1\n"));

#include <string>

#include "geom/picture/picture.h"

namespace geom::picture {

// The depths as a portable float map: one channel, little endian, rows from the bottom; metres, 0
// for nothing. Needs a depth for each pixel.
std::string pfm(const Picture& picture);

// YUV4MPEG2 as ffmpeg and mpv read it: 4:2:0, BT.601 in the limited range, square pixels. `rate` is
// frames per second, > 0. A frame needs a colour for each pixel.
std::string y4m_header(int width, int height, double rate);
std::string y4m_frame(const Picture& picture);

}  // namespace geom::picture
