#pragma once

// Pictures as WebP, a tenth of the size of PNG, which every browser shows.

#include <string>

#include "geom/picture/png_image.h"

namespace view {

// Lossy, quality 50 of 100. Throws std::runtime_error above 16,383 pixels a side.
std::string webp(const geom::picture::Pixels& picture);

}  // namespace view
