#pragma once

// Pictures as the bytes of files: PFM, YUV4MPEG2. PNG is in png_image.h.

#include <string>

#include "picture.h"

namespace render {

// Portable float map: one channel, little endian, rows from the bottom; metres, 0 for nothing.
std::string pfm(const Picture& picture);

// YUV4MPEG2 as ffmpeg and mpv read it: 4:2:0, BT.601 in the limited range, square pixels.
std::string y4m_header(int width, int height, double rate);
std::string y4m_frame(const Picture& picture);

}  // namespace render
